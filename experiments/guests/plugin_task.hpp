// SPDX-License-Identifier: GPL-3.0-or-later
//
// A batch as a plug-in is asked about it (spaces/plugin/clipscope_plugin.h).
#pragma once

#include <cstddef>
#include <cstdint>

#include "experiments/contestants/batch.hpp"
#include "experiments/guests/plugin_channel.hpp"
#include "spaces/plugin/clipscope_plugin.h"

namespace clipscope::experiments {

// The capability bits of what a batch holds, and of its depth convention.
std::uint32_t primitive_bit(int vertices);
std::uint32_t depth_bit(DepthRange depth);

// Whether the plug-in is asked about the frustum in view space.
bool takes_in_view_space(const Plugin& plugin, const Frustum<double>& frustum);

// All but the primitives and their count. T: float or double.
template <class T>
clipscope_task task_of(const Batch& batch);

// The first vertex of a primitive; of batch.size() the number of all vertices.
std::size_t first_vertex(const Batch& batch, std::size_t primitive);

// Of the polygon of one primitive; see clipscope_answer.
std::size_t most_vertices(const Batch& batch, const clipscope_task& task);

// Writes all vertices of the batch: the task's stride of numbers for each.
template <class T>
void write_vertices(const Batch& batch, T* to);

}  // namespace clipscope::experiments
