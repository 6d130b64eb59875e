#pragma once

namespace incision {

/// From now on a node is only asked to end, by Ctrl-C, SIGTERM, `rosnode kill` or another node of its name: its topics
/// stay up until it has said what is left to say. roscpp by itself would take them down first. A second signal ends the
/// program at once.
void endWhenAsked();

/// Whether the node has been asked to end, or roscpp has come to its end.
bool endAsked();

}  // namespace incision
