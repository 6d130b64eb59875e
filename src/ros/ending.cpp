#include "incision/ros/ending.h"

#include <ros/init.h>
#include <ros/xmlrpc_manager.h>

#include <atomic>
#include <csignal>

namespace incision {
namespace {

std::atomic<bool> asked = false;  // lock-free, so that a signal handler may set it
static_assert(std::atomic<bool>::is_always_lock_free);

void onSignal(int signal) {
  asked = true;
  std::signal(signal, SIG_DFL);
}

/// The master's and rosnode's way of asking.
void onRequest(XmlRpc::XmlRpcValue&, XmlRpc::XmlRpcValue& result) {
  asked = true;
  result = ros::xmlrpc::responseInt(1, "", 0);
}

}  // namespace

void endWhenAsked() {
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  const ros::XMLRPCManagerPtr& requests = ros::XMLRPCManager::instance();
  requests->unbind("shutdown");
  requests->bind("shutdown", onRequest);
}

bool endAsked() { return asked || !ros::ok(); }

}  // namespace incision
