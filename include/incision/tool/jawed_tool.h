#pragma once

#include "incision/rigid/jaw_links.h"
#include "incision/tool/tool.h"

namespace incision {

/// A tool that opens and closes: its link and its jaws, as the joint of its settings moves them.
class JawedTool : public Tool {
 public:
  /// `touching` as jawTouching makes it. The settings have a joint, from which `links` have been made.
  JawedTool(const ToolSettings& settings, JawLinks links, Touching touching);

  int groups() const override { return links_.groups(); }
  Pose groupPose(int group, double angle) const override { return links_.pose(group, angle); }
  ToolForm form() const override;
  ToolReport report() const override;

  const JawLinks& links() const { return links_; }

 private:
  JawLinks links_;
};

/// The joint's links of a tool's description. Throws InputError as JawLinks does.
JawLinks jawLinksOf(const ToolSettings& settings, const Description& description);

/// What of each group touches with the tool's friction; empty where nothing touches. `edges` of the groups, from the
/// first on, as far as they have one.
Touching jawTouching(const ToolSettings& settings, const JawLinks& links, const std::vector<std::optional<Edge>>& edges,
                     ContactSkin* skin);

}  // namespace incision
