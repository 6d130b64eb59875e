#pragma once

#include <ros/node_handle.h>

#include "incision/ros/live_config.h"
#include "incision/scene/scene.h"

namespace incision {

/// The node's private parameters.
struct NodeSettings {
  Scene scene;                    ///< ~scene, whose relative paths are taken from ~scene_folder
  Descriptions descriptions;      ///< ~tool_description, ~obstacle_description
  MarkerSettings markers;         ///< ~marker_rate, ~marker_field
  double transform_timeout = 1;   ///< ~transform_timeout [s], 0 … 60: how long a command waits for its transform
  double max_lag = 5;             ///< ~max_lag [s], 1 … 1e6: lag behind /clock that is made up for
  double diagnostic_period = 1;   ///< ~diagnostic_period [s], 0.1 … 60: time between two diagnoses
  std::string checkpoint_folder;  ///< ~checkpoint_folder: where checkpoints outlast the node; empty: nowhere
  double autosave = 0;  ///< ~autosave [s], 0.1 … 1e6: how old the newest checkpoint becomes at most; 0: saves none
  std::string restore;  ///< ~restore: the checkpoint to start from, or `last`; empty: none
};

/// Reads and checks them all. Throws InputError with parameter, value and what is allowed, and for a parameter that the
/// node does not know.
NodeSettings loadSettings(const ros::NodeHandle& node);

}  // namespace incision
