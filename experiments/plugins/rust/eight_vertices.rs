// SPDX-License-Identifier: MIT
//
// A clipper as a plug-in of clipscope, in Rust, without any crate: all six planes before the divide.
//
// Its bug is a number: "a triangle cut by six planes has at most 8 vertices". It has 9, and the
// ninth is written beyond the array: in C over whatever comes next, here into a panic.
#![allow(non_camel_case_types)]

use std::os::raw::c_char;

// What clipscope_plugin.h declares.
const ABI: u32 = 1;
const FLOAT: u32 = 1 << 0;
const CLIP_SPACE: u32 = 1 << 3;
const TRIANGLES: u32 = 1 << 6;
const DEPTH_MINUS_ONE_TO_ONE: u32 = 1 << 8;
const THREAD_SAFE: u32 = 1 << 19;
const MOST_ATTRIBUTES: usize = 32;
const DONE: i32 = 0;
const FAILED: i32 = 1;

#[repr(C)]
pub struct clipscope_frustum {
    numbers: [f64; 8],
    is_orthographic: u32,
    is_infinite: u32,
}

#[repr(C)]
pub struct clipscope_task {
    struct_size: u32,
    scalar: u32,
    space: u32,
    primitive: u32,
    depth: u32,
    depth_clamp: u32,
    open_sides: u32,
    clip_distances: u32,
    attributes: u32,
    stride: u32,
    count: usize,
    vertices: usize,
    ends: *const usize,
    floats: *const f32,
    doubles: *const f64,
    frustum: clipscope_frustum,
    matrix: [f64; 16],
    point_half_size: [f64; 2],
}

#[repr(C)]
pub struct clipscope_answer {
    struct_size: u32,
    stride: u32,
    capacity: usize,
    most_vertices: usize,
    floats: *mut f32,
    doubles: *mut f64,
    ends: *mut usize,
}

#[repr(C)]
pub struct clipscope_plugin {
    struct_size: u32,
    abi_version: u32,
    name: *const c_char,
    summary: *const c_char,
    source: *const c_char,
    capabilities: u32,
    most_attributes: u32,
    clip: unsafe extern "C" fn(*const clipscope_task, *mut clipscope_answer) -> i32,
}

// Its pointers are to texts that never change.
unsafe impl Sync for clipscope_plugin {}

// x y z w, then attributes; x y z 1/w after the divide.
type Vertex = [f32; 4 + MOST_ATTRIBUTES];

const MOST_VERTICES: usize = 8;

struct Polygon {
    vertices: [Vertex; MOST_VERTICES],
    size: usize,
}

impl Polygon {
    fn new() -> Polygon {
        Polygon { vertices: [[0.0; 4 + MOST_ATTRIBUTES]; MOST_VERTICES], size: 0 }
    }

    fn push(&mut self, vertex: Vertex) {
        self.vertices[self.size] = vertex;
        self.size += 1;
    }

    fn vertices(&self) -> &[Vertex] {
        &self.vertices[..self.size]
    }
}

fn between(a: &Vertex, b: &Vertex, t: f32) -> Vertex {
    std::array::from_fn(|i| a[i] + t * (b[i] - a[i]))
}

// The part where w + side * coordinate >= 0: Sutherland and Hodgman, Reentrant Polygon Clipping,
// 1974.
fn cut(polygon: &Polygon, axis: usize, side: f32) -> Polygon {
    let distance = |v: &Vertex| v[3] + side * v[axis];
    let mut out = Polygon::new();
    for (i, a) in polygon.vertices().iter().enumerate() {
        let b = &polygon.vertices[(i + 1) % polygon.size];
        let (d_a, d_b) = (distance(a), distance(b));
        if d_a >= 0.0 {
            out.push(*a);
        }
        if (d_a >= 0.0) != (d_b >= 0.0) {
            let mut v = between(a, b, d_a / (d_a - d_b));
            v[axis] = -side * v[3];
            out.push(v);
        }
    }
    out
}

fn divide(v: &mut Vertex) {
    for i in 0..3 {
        v[i] /= v[3];
    }
    v[3] = 1.0 / v[3];
}

fn clipped(triangle: Polygon) -> Polygon {
    let is_finite = |v: &Vertex| v[..4].iter().all(|x| x.is_finite());
    if !triangle.vertices().iter().all(is_finite) {
        return Polygon::new();
    }
    let mut polygon = triangle;
    for axis in 0..3 {
        for side in [1.0, -1.0] {
            polygon = cut(&polygon, axis, side);
        }
    }
    if polygon.vertices().iter().any(|v| v[3] <= 0.0) {
        return Polygon::new(); // x = y = z = w = 0, or all of it in the eye
    }
    for i in 0..polygon.size {
        divide(&mut polygon.vertices[i]);
    }
    polygon
}

unsafe extern "C" fn clip(task: *const clipscope_task, answer: *mut clipscope_answer) -> i32 {
    let (task, answer) = (&*task, &mut *answer);
    let stride = task.stride as usize;
    let input = std::slice::from_raw_parts(task.floats, task.vertices * stride);
    let ends = std::slice::from_raw_parts_mut(answer.ends, task.count);
    let mut end = 0;
    for (numbers, its_end) in input.chunks_exact(3 * stride).zip(ends) {
        let mut triangle = Polygon::new();
        for vertex in numbers.chunks_exact(stride) {
            let mut v = [0.0; 4 + MOST_ATTRIBUTES];
            v[..stride].copy_from_slice(vertex);
            triangle.push(v);
        }
        let polygon = clipped(triangle);
        if end + polygon.size > answer.capacity {
            return FAILED;
        }
        for v in polygon.vertices() {
            std::ptr::copy_nonoverlapping(v.as_ptr(), answer.floats.add(end * stride), stride);
            end += 1;
        }
        *its_end = end;
    }
    DONE
}

static PLUGIN: clipscope_plugin = clipscope_plugin {
    struct_size: std::mem::size_of::<clipscope_plugin>() as u32,
    abi_version: ABI,
    name: b"example/eight_vertices\0".as_ptr() as *const c_char,
    summary: b"six planes before the divide, in an array of 8 vertices\0".as_ptr() as *const c_char,
    source: b"an example, with a bug\0".as_ptr() as *const c_char,
    capabilities: FLOAT | CLIP_SPACE | TRIANGLES | DEPTH_MINUS_ONE_TO_ONE | THREAD_SAFE,
    most_attributes: MOST_ATTRIBUTES as u32,
    clip,
};

#[no_mangle]
pub extern "C" fn clipscope_plugin_entry(abi_version: u32) -> *const clipscope_plugin {
    if abi_version == ABI {
        &PLUGIN
    } else {
        std::ptr::null()
    }
}
