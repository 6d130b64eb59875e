#pragma once

#include <optional>
#include <vector>

#include "incision/contact/contact.h"
#include "incision/contact/obstacles.h"
#include "incision/tool/tool_in_step.h"

namespace incision {

/// Contact of a body with the shapes of a tool that move together.
class ToolContact : public Contact {
 public:
  /// `shapes` are those of one group of the tool, all on link 0, `friction` Coulomb's coefficient of these alone.
  /// `edge`: the group's cutting edge in its frame, where there is one; near it the shapes give way while the tool is
  /// active. `skin` must outlive this.
  ToolContact(int group, Obstacles shapes, double friction, const std::optional<Edge>& edge, ContactSkin* skin);

  /// The tool that the shapes belong to, which must outlive this. To be called once, before anything else.
  void setTool(ToolInStep* tool) { tool_ = tool; }

  int group() const { return group_; }
  const Obstacles& shapes() const { return shapes_; }

  void accept(const StepSpan& span, Span<const Vec3> moved, const Motion& end, const Wrench& felt) override;
  bool hasOtherEnd() const override { return true; }

 protected:
  bool isThere() const override { return tool_->in_place; }
  void find(const ContactSkin& skin, const StepStart& start, const std::vector<Touch>& touches,
            std::vector<Candidate>* candidates) override;

 private:
  int group_;
  Obstacles shapes_;
  std::optional<Edge> edge_;
  ToolInStep* tool_ = nullptr;
  std::vector<RigidMotion> motions_;  // of the one link
};

}  // namespace incision
