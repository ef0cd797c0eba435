// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/system/apart.hpp"

#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>

#include "base/system/interrupt.hpp"

namespace flatdyn {
namespace {

using TaskNumber = std::uint32_t;

// The bytes before a text in a pipe.
struct Head {
  TaskNumber task = 0;
  std::uint64_t length = 0;
};

struct Pipe {
  int read = -1, write = -1;

  bool open() {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) return false;
    read = ends[0];
    write = ends[1];
    return true;
  }
};

void close_end(int& end) {
  if (end >= 0) ::close(end);
  end = -1;
}

bool write_all(int to, const void* data, std::size_t length) {
  const auto* bytes = static_cast<const char*>(data);
  while (length > 0) {
    const ssize_t written = ::write(to, bytes, length);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes += written;
    length -= static_cast<std::size_t>(written);
  }
  return true;
}

// Takes tasks and writes their texts until there are no more. Does not return: nothing of the parent is cleaned up.
[[noreturn]] void work(int tasks, int results, const std::function<std::string(std::size_t)>& compute) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // it does not outlive the parent
  TaskNumber task = 0;
  while (::read(tasks, &task, sizeof(task)) == static_cast<ssize_t>(sizeof(task))) {
    try {
      const std::string text = compute(task);
      const Head head{task, text.size()};
      if (!write_all(results, &head, sizeof(head)) || !write_all(results, text.data(), text.size())) break;
    } catch (...) {
      continue;  // the text is missing; whoever asked for it computes it again, and sees why
    }
  }
  ::_exit(0);
}

struct Worker {
  pid_t process = -1;
  int results = -1;
  std::string received;
};

// Moves whole texts from what a worker has sent.
void take_texts(Worker& worker, std::vector<std::optional<std::string>>& texts) {
  Head head;
  while (worker.received.size() >= sizeof(head)) {
    std::memcpy(&head, worker.received.data(), sizeof(head));
    if (head.task >= texts.size() || worker.received.size() - sizeof(head) < head.length) return;
    texts[head.task] = worker.received.substr(sizeof(head), head.length);
    worker.received.erase(0, sizeof(head) + head.length);
  }
}

// Reads what a worker has sent; false at its end.
bool receive(Worker& worker) {
  std::array<char, 1U << 16U> buffer;
  const ssize_t length = ::read(worker.results, buffer.data(), buffer.size());
  if (length < 0) return errno == EINTR;
  worker.received.append(buffer.data(), static_cast<std::size_t>(length));
  return length > 0;
}

// Starts a worker, unless the machine has no room for one.
void start(std::vector<Worker>& workers, Pipe& tasks, const std::function<std::string(std::size_t)>& compute) {
  Pipe results;
  if (!results.open()) return;
  const pid_t process = fork_without_registrations();
  if (process == 0) {
    close_end(tasks.write);
    work(tasks.read, results.write, compute);
  }
  close_end(results.write);
  if (process < 0) {
    close_end(results.read);
    return;
  }
  end_when_interrupted(process);
  workers.push_back({process, results.read, {}});
}

void gather(std::vector<Worker>& workers, std::vector<std::optional<std::string>>& texts) {
  std::size_t open = workers.size();
  while (open > 0) {
    std::vector<pollfd> waiting;
    for (const Worker& worker : workers) waiting.push_back({worker.results, POLLIN, 0});
    if (::poll(waiting.data(), waiting.size(), -1) < 0 && errno != EINTR) break;
    for (std::size_t k = 0; k < workers.size(); ++k) {
      if (workers[k].results < 0 || waiting[k].revents == 0) continue;
      const bool goes_on = receive(workers[k]);
      take_texts(workers[k], texts);
      if (goes_on) continue;
      close_end(workers[k].results);
      --open;
    }
  }
  for (Worker& worker : workers) {
    while (::waitpid(worker.process, nullptr, 0) < 0 && errno == EINTR) continue;
    forget_when_interrupted(worker.process);
  }
}

}  // namespace

std::size_t processor_count() {
  cpu_set_t set;
  if (::sched_getaffinity(0, sizeof(set), &set) != 0) return 1;
  return static_cast<std::size_t>(std::max(1, CPU_COUNT(&set)));
}

std::vector<std::optional<std::string>> computed_apart(std::size_t tasks, std::size_t processes,
                                                       const std::function<std::string(std::size_t)>& compute) {
  constexpr std::size_t kMostTasks = 1000;  // their numbers fit into a pipe at once
  std::vector<std::optional<std::string>> texts(tasks);
  Pipe numbers;
  if (tasks > kMostTasks || !numbers.open()) return texts;
  for (TaskNumber task = 0; task < tasks; ++task) write_all(numbers.write, &task, sizeof(task));
  std::vector<Worker> workers;
  for (std::size_t k = 0; k < std::min(tasks, processes); ++k) start(workers, numbers, compute);
  close_end(numbers.write);
  close_end(numbers.read);
  gather(workers, texts);
  return texts;
}

}  // namespace flatdyn
