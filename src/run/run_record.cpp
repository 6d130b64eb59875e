#include "incision/run/run_record.h"

#include "incision/run/output_file.h"

namespace incision {

RunRecord::RunRecord(const std::string& path) : file_(openOutput(path)) {
  file_ << "step,time,crack_elements,parts,copies,cracks,pieces,momentum_x,momentum_y,momentum_z,kinetic_energy,"
           "elastic_energy,max_displacement,iterations,residual,step_ms\n"
        << std::flush;
}

void RunRecord::write(const DeformableBody& body, const StepResult& step) {
  const BodyCounts counts = body.counts();
  const BodyMotion motion = body.motion();
  file_ << body.steps() << ',' << body.time() << ',' << counts.crack_elements << ',' << counts.parts << ','
        << counts.copies << ',' << counts.cracks << ',' << counts.pieces << ',' << motion.momentum.x() << ','
        << motion.momentum.y() << ',' << motion.momentum.z() << ',' << motion.kinetic_energy << ','
        << motion.elastic_energy << ',' << motion.max_displacement << ',' << step.iterations << ',' << step.residual
        << ',' << step.step_ms << '\n'
        << std::flush;
}

}  // namespace incision
