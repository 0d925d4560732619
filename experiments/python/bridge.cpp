// SPDX-License-Identifier: GPL-3.0-or-later
//
// A Python function as a plug-in: what clipscope.exact.verify gives to the program.
//
// The plug-in's host is a process of its own. From there this library asks the Python process over
// a Unix socket, whose path is in CLIPSCOPE_PYTHON_SOCKET: a task goes there, an answer comes back
// (exact/_guest.py). Numbers are in the machine's own format, since both ends are the same machine.
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <type_traits>

#include "clipscope_plugin.h"

namespace {

// What is sent before the vertices of a task; _guest.py reads the same.
struct Question {
  std::uint32_t scalar, space, primitive, depth;
  std::uint32_t depth_clamp, open_sides, clip_distances, attributes;
  std::uint32_t stride, is_orthographic, is_infinite, unused;
  std::uint64_t count, vertices, most_vertices;
  double frustum[8], matrix[16];
};
static_assert(std::is_trivially_copyable_v<Question>);

// What comes back before the ends of the polygons and their vertices.
struct Reply {
  std::uint64_t is_done, vertices;
};

// What the Python process says of the function when a host connects.
struct Introduction {
  std::uint32_t capabilities, most_attributes;
  char name[64], summary[192];
};

int connected = -1;

bool send_all(const void* data, std::size_t bytes) {
  const char* from = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t sent = send(connected, from, bytes, MSG_NOSIGNAL);
    if (sent <= 0) return false;
    from += sent;
    bytes -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool receive_all(void* data, std::size_t bytes) {
  char* to = static_cast<char*>(data);
  while (bytes > 0) {
    const ssize_t received = recv(connected, to, bytes, 0);
    if (received <= 0) return false;
    to += received;
    bytes -= static_cast<std::size_t>(received);
  }
  return true;
}

bool connect_to(const char* path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (std::strlen(path) >= sizeof(address.sun_path)) return false;
  std::strcpy(address.sun_path, path);
  connected = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  return connected >= 0 &&
         connect(connected, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

Question question_of(const clipscope_task& task, const clipscope_answer& answer) {
  const clipscope_frustum& f = task.frustum;
  Question q{task.scalar,
             task.space,
             task.primitive,
             task.depth,
             task.depth_clamp,
             task.open_sides,
             task.clip_distances,
             task.attributes,
             task.stride,
             f.is_orthographic,
             f.is_infinite,
             0,
             task.count,
             task.vertices,
             answer.most_vertices,
             {f.left, f.right, f.bottom, f.top, f.z_near, f.z_far, f.shear_x, f.shear_y},
             {}};
  std::memcpy(q.matrix, task.matrix, sizeof q.matrix);
  return q;
}

std::int32_t clip(const clipscope_task* task, clipscope_answer* answer) {
  const bool is_float = task->scalar == CLIPSCOPE_FLOAT;
  const std::size_t size = is_float ? sizeof(float) : sizeof(double);
  const void* const from = is_float ? static_cast<const void*>(task->floats) : task->doubles;
  void* const to = is_float ? static_cast<void*>(answer->floats) : answer->doubles;
  const Question question = question_of(*task, *answer);
  Reply reply{};
  if (!send_all(&question, sizeof question) ||
      !send_all(from, task->vertices * task->stride * size) || !receive_all(&reply, sizeof reply)) {
    std::fputs("the Python process does not answer\n", stderr);
    return CLIPSCOPE_FAILED;
  }
  if (reply.is_done == 0) return CLIPSCOPE_FAILED;
  if (reply.vertices > answer->capacity) return CLIPSCOPE_FAILED;
  const bool is_read = receive_all(answer->ends, task->count * sizeof(std::size_t)) &&
                       receive_all(to, reply.vertices * answer->stride * size);
  return is_read ? CLIPSCOPE_DONE : CLIPSCOPE_FAILED;
}

Introduction introduction;
clipscope_plugin description;

}  // namespace

extern "C" CLIPSCOPE_EXPORT const clipscope_plugin* clipscope_plugin_entry(
    std::uint32_t abi_version) {
  const char* const path = std::getenv("CLIPSCOPE_PYTHON_SOCKET");
  if (abi_version != CLIPSCOPE_PLUGIN_ABI || path == nullptr || !connect_to(path) ||
      !receive_all(&introduction, sizeof introduction)) {
    return nullptr;
  }
  description = {sizeof description,
                 CLIPSCOPE_PLUGIN_ABI,
                 introduction.name,
                 introduction.summary,
                 "a Python function",
                 introduction.capabilities,
                 introduction.most_attributes,
                 clip};
  return &description;
}
