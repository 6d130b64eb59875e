#include "benchmark/child.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <iostream>
#include <stdexcept>

namespace incision::bench {
namespace {

Json rowOrReason(const std::function<Json()>& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    return {{"error", error.what()}};
  }
}

void writeAll(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = write(file, text.data() + done, text.size() - done);
    if (count < 0) return;
    done += static_cast<std::size_t>(count);
  }
}

std::string readAll(int file) {
  std::string text;
  std::array<char, 4096> buffer{};
  for (ssize_t count; (count = read(file, buffer.data(), buffer.size())) > 0;)
    text.append(buffer.data(), static_cast<std::size_t>(count));
  return text;
}

}  // namespace

Json inChild(const std::function<Json()>& work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe to a child process");
  std::cout.flush();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no child process");
  if (child == 0) {
    close(ends[0]);
    writeAll(ends[1], rowOrReason(work).dump());
    _exit(0);
  }
  close(ends[1]);
  const std::string text = readAll(ends[0]);
  close(ends[0]);
  rusage usage{};
  int status = 0;
  wait4(child, &status, 0, &usage);
  if (status != 0) throw std::runtime_error("a run ended with status " + std::to_string(status));

  Json row = Json::parse(text);
  if (row.contains("error")) throw std::runtime_error(row["error"].get<std::string>());
  const double peak = 1024.0 * static_cast<double>(usage.ru_maxrss);  // Linux counts in KiB
  row["peak_mb"] = peak / 1e6;
  if (row.contains("elements")) row["kb_per_element"] = peak / 1e3 / row["elements"].get<double>();
  return row;
}

}  // namespace incision::bench
