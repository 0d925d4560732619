// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws what webgl_call.cpp writes with WebGL 2 into images of 32-bit floats, and reads them back.
// Whoever asks the browser's GPU process something waits for it, so a draw call asks twice only:
// for all pixels and for errors.
'use strict';

class Drawing {
  constructor() {
    this.gl = document.createElement('canvas').getContext('webgl2');
    if (!this.gl) throw new Error('there is no WebGL 2');
    this.extensions = {};
    for (const name of ['EXT_color_buffer_float', 'EXT_float_blend', 'EXT_clip_control', 'EXT_depth_clamp',
      'NV_shader_noperspective_interpolation', 'WEBGL_clip_cull_distance', 'WEBGL_provoking_vertex',
      'WEBGL_debug_renderer_info']) {
      this.extensions[name] = this.gl.getExtension(name);
    }
    if (!this.extensions.EXT_color_buffer_float) throw new Error('WebGL has no EXT_color_buffer_float');
    this.limits = this.describe();
    this.programs = new Map();
    this.targets = new Map();
    this.setUp();
  }

  // What stays as it is. A vertex is 16 floats: four for each input of the shader, by its location.
  setUp() {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, gl.createBuffer());
    for (let location = 0; location < 4; ++location) {
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, 4, gl.FLOAT, false, 64, 16 * location);
    }
    gl.depthFunc(gl.ALWAYS);
    gl.blendFunc(gl.ONE, gl.ONE);
    gl.disable(gl.DITHER);
  }

  isLost() { return this.gl.isContextLost(); }

  describe() {
    const { gl, extensions } = this;
    const debug = extensions.WEBGL_debug_renderer_info;
    const distances = extensions.WEBGL_clip_cull_distance;
    return {
      version: gl.getParameter(gl.VERSION),
      renderer: gl.getParameter(debug ? debug.UNMASKED_RENDERER_WEBGL : gl.RENDERER),
      subpixelBits: gl.getParameter(gl.SUBPIXEL_BITS),
      maxSize: Math.min(gl.getParameter(gl.MAX_TEXTURE_SIZE), ...gl.getParameter(gl.MAX_VIEWPORT_DIMS)),
      maxAttachments: Math.min(gl.getParameter(gl.MAX_DRAW_BUFFERS), gl.getParameter(gl.MAX_COLOR_ATTACHMENTS)),
      maxClipDistances: distances ? gl.getParameter(distances.MAX_CLIP_DISTANCES_WEBGL) : 0,
      maxPointSize: gl.getParameter(gl.ALIASED_POINT_SIZE_RANGE)[1],
      clipControl: !!extensions.EXT_clip_control,
      depthClamp: !!extensions.EXT_depth_clamp,
      provokingVertex: !!extensions.WEBGL_provoking_vertex,
      noperspective: !!extensions.NV_shader_noperspective_interpolation,
    };
  }

  // For each pass an array of floats for each of its outputs, and one of depth where it has that.
  draw(call) {
    const { gl } = this;
    const images = call.passes.reduce((sum, pass) => sum + pass.outputs.length + (pass.hasDepth ? 1 : 0), 0);
    this.imageFloats = 4 * call.width * call.height;
    this.imagesRead = 0;
    gl.bufferData(gl.PIXEL_PACK_BUFFER, 4 * images * this.imageFloats, gl.STREAM_READ);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(call.vertices.flat()), gl.STREAM_DRAW);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(call.indices), gl.STREAM_DRAW);
    const places = call.passes.map((pass) => this.drawPass(call, pass));
    const floats = new Float32Array(images * this.imageFloats);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, floats);
    const error = gl.getError();
    if (error !== gl.NO_ERROR) throw new Error(`WebGL error 0x${error.toString(16)}`);
    return places.map((ofPass) => ofPass.map((place) => this.channelsAt(floats, place)));
  }

  // Where its outputs will be among what is read.
  drawPass(call, pass) {
    const { gl } = this;
    const { program, pointSize } = this.program(pass.vertex, pass.fragment);
    this.setState(call);
    this.enable(gl.DEPTH_TEST, pass.hasDepth);
    this.enable(gl.BLEND, pass.addsUp);
    // A float of 16 bits counts to 2048, where those of 32 can't be added up.
    const format = pass.addsUp && !this.extensions.EXT_float_blend ? gl.RGBA16F : gl.RGBA32F;
    const target = this.target(call, format, pass.outputs.length, pass.hasDepth);
    pass.outputs.forEach((output, i) => gl.clearBufferfv(gl.COLOR, i, new Array(4).fill(output.background)));
    if (pass.hasDepth) gl.clearBufferfv(gl.DEPTH, 0, [call.noDepth]);
    gl.useProgram(program);
    gl.uniform1f(pointSize, call.pointSize);
    if (call.indices.length > 0) gl.drawElements(call.mode, call.indices.length, gl.UNSIGNED_INT, 0);
    else gl.drawArrays(call.mode, 0, call.vertices.length);
    const places = pass.outputs.map((output, i) => this.read(call, i, output.channels));
    if (pass.hasDepth) places.push(this.readDepth(call, target.depth));
    return places;
  }

  setState(call) {
    const { gl } = this;
    const { EXT_depth_clamp: depth, EXT_clip_control: control, WEBGL_clip_cull_distance: distances,
      WEBGL_provoking_vertex: provoking } = this.extensions;
    gl.viewport(...call.viewport);
    if (depth) this.enable(depth.DEPTH_CLAMP_EXT, call.depthClamp);
    if (control) control.clipControlEXT(control.LOWER_LEFT_EXT,
      call.zeroToOne ? control.ZERO_TO_ONE_EXT : control.NEGATIVE_ONE_TO_ONE_EXT);
    for (let i = 0; i < this.limits.maxClipDistances; ++i) {
      this.enable(distances.CLIP_DISTANCE0_WEBGL + i, i < call.clipDistances);
    }
    if (provoking) provoking.provokingVertexWEBGL(call.provokesFirst
      ? provoking.FIRST_VERTEX_CONVENTION_WEBGL : provoking.LAST_VERTEX_CONVENTION_WEBGL);
  }

  enable(what, isOn) {
    if (isOn) this.gl.enable(what);
    else this.gl.disable(what);
  }

  // Binds a framebuffer with so many attachments, which is kept while targets are of that size.
  target(call, format, attachments, hasDepth) {
    const { gl } = this;
    const size = `${call.width} ${call.height}`;
    if (this.size !== size) this.forgetTargets();
    this.size = size;
    const key = `${format} ${attachments} ${hasDepth}`;
    if (!this.targets.has(key)) this.targets.set(key, this.makeTarget(call, format, attachments, hasDepth));
    const target = this.targets.get(key);
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
    return target;
  }

  forgetTargets() {
    for (const { framebuffer, colours, depth } of this.targets.values()) {
      this.gl.deleteFramebuffer(framebuffer);
      for (const image of [...colours, depth]) this.gl.deleteTexture(image);
    }
    this.targets.clear();
  }

  makeTarget(call, format, attachments, hasDepth) {
    const { gl } = this;
    const framebuffer = gl.createFramebuffer(), colours = [];
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    for (let i = 0; i < attachments; ++i) {
      colours.push(this.attach(gl.COLOR_ATTACHMENT0 + i, call, format));
    }
    const depth = hasDepth ? this.attach(gl.DEPTH_ATTACHMENT, call, gl.DEPTH_COMPONENT32F) : null;
    gl.drawBuffers(colours.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
    const status = gl.checkFramebufferStatus(gl.FRAMEBUFFER);
    if (status !== gl.FRAMEBUFFER_COMPLETE) throw new Error(`incomplete framebuffer 0x${status.toString(16)}`);
    return { framebuffer, colours, depth };
  }

  attach(attachment, call, format) {
    const { gl } = this;
    const image = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, image);
    gl.texStorage2D(gl.TEXTURE_2D, 1, format, call.width, call.height);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, attachment, gl.TEXTURE_2D, image, 0);
    return image;
  }

  // Orders an attachment to be read; rows go up from the lowest one.
  read(call, attachment, channels) {
    const { gl } = this;
    const number = this.imagesRead++;
    gl.readBuffer(gl.COLOR_ATTACHMENT0 + attachment);
    gl.readPixels(0, 0, call.width, call.height, gl.RGBA, gl.FLOAT, 4 * number * this.imageFloats);
    return { first: number * this.imageFloats, channels };
  }

  // Depth can't be read but by a shader, which writes it as a colour.
  readDepth(call, depth) {
    const { gl } = this;
    const { program } = this.program(`#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }`,
    `#version 300 es
precision highp float;
uniform highp sampler2D depth;
out vec4 colour;
void main() { colour = vec4(texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r); }`);
    this.setState({ ...call, viewport: [0, 0, call.width, call.height], clipDistances: 0 });
    gl.disable(gl.DEPTH_TEST);
    this.target(call, gl.RGBA32F, 1, false);
    gl.bindTexture(gl.TEXTURE_2D, depth);
    gl.useProgram(program);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    return this.read(call, 0, 1);
  }

  channelsAt(floats, { first, channels }) {
    if (channels === 4) return floats.slice(first, first + this.imageFloats);
    const values = new Float32Array(channels * this.imageFloats / 4);
    for (let i = 0; i < values.length; ++i) {
      values[i] = floats[first + 4 * Math.floor(i / channels) + i % channels];
    }
    return values;
  }

  program(vertex, fragment) {
    const { gl } = this;
    const key = vertex + fragment;
    if (this.programs.has(key)) return this.programs.get(key);
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    const made = { program, pointSize: gl.getUniformLocation(program, 'point_size') };
    this.programs.set(key, made);
    return made;
  }
}
