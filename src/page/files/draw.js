// What is drawn with: the page's WebGL 2, programs of its shaders, buffers and textures.
const texels = {RGBA8: ["RGBA", "UNSIGNED_BYTE"], R8UI: ["RED_INTEGER", "UNSIGNED_BYTE"],
  R32UI: ["RED_INTEGER", "UNSIGNED_INT"], RGBA32UI: ["RGBA_INTEGER", "UNSIGNED_INT"], RGBA32F: ["RGBA", "FLOAT"]};

function rendererName() {
  const gl = document.createElement("canvas").getContext("webgl2");
  return gl?.getParameter(gl.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER) ?? "";
}

class Tools {
  constructor(canvas, live) {
    // Where the processor draws, smooth edges cost as much as the rest: too much for a picture that moves.
    const antialias = !live || !/swiftshader|llvmpipe|softpipe|software|basic render/i.test(rendererName());
    this.gl = canvas.getContext("webgl2", {antialias, preserveDrawingBuffer: true});
    if (!this.gl) throw new Error("no WebGL 2");
    const {FLOAT, FLOAT_VEC2, FLOAT_VEC3, FLOAT_VEC4, UNSIGNED_INT} = this.gl;
    Object.assign(this, {shaders: pageData("shaders"), programs: {}, calls: {[FLOAT]: "1f", [FLOAT_VEC2]: "2fv",
      [FLOAT_VEC3]: "3fv", [FLOAT_VEC4]: "4fv", [UNSIGNED_INT]: "1ui"}});
  }
  // A program and what sets its uniforms by their names. A second word in its name is defined in its text.
  linked(name) {
    const {gl} = this, program = gl.createProgram(), set = {}, [text, word] = name.split(" ");
    this.shaders[text].forEach((stage, k) => {
      const shader = gl.createShader(k ? gl.FRAGMENT_SHADER : gl.VERTEX_SHADER);
      gl.shaderSource(shader, word ? stage.replace("\n", `\n#define ${word}\n`) : stage);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    });
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
      throw new Error(name + ": " + gl.getAttachedShaders(program).map((shader) => gl.getShaderInfoLog(shader)));
    for (let k = 0, textures = 0; k < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++k) {
      const {name, type} = gl.getActiveUniform(program, k), place = gl.getUniformLocation(program, name);
      const call = "uniform" + this.calls[type], unit = textures;
      const kind = type === gl.UNSIGNED_INT_SAMPLER_2D_ARRAY ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D;
      const bind = (texture) => {
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(kind, texture);
        gl.uniform1i(place, unit);
      };
      if (name.startsWith("t_")) ++textures;
      set[name.replace("[0]", "")] = name.startsWith("t_") ? bind : type === gl.FLOAT_MAT4
        ? (matrix) => gl.uniformMatrix4fv(place, false, matrix) : (value) => gl[call](place, value);
    }
    return {program, set};
  }
  // Where a pass draws, and what it tests and mixes.
  begin({target = null, place = [0, 0], size, depth = "LESS", blend = false}) {
    const {gl} = this, set = (what, on) => gl[on ? "enable" : "disable"](gl[what]);
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
    gl.viewport(...place, ...size);
    set("DEPTH_TEST", depth);
    if (depth) gl.depthFunc(gl[depth]);
    set("BLEND", blend);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }
  // Vertices with so many numbers an attribute; whole ones where that is negative.
  buffer(numbers, layout) {
    const {gl} = this, vertices = gl.createVertexArray(), data = gl.createBuffer();
    const each = layout.reduce((sum, size) => sum + Math.abs(size), 0);
    gl.bindVertexArray(vertices);
    gl.bindBuffer(gl.ARRAY_BUFFER, data);
    gl.bufferData(gl.ARRAY_BUFFER, ArrayBuffer.isView(numbers) ? numbers : new Float32Array(numbers), gl.STATIC_DRAW);
    layout.reduce((first, size, k) => {
      gl.enableVertexAttribArray(k);
      if (size > 0) gl.vertexAttribPointer(k, size, gl.FLOAT, false, 4 * each, 4 * first);
      else gl.vertexAttribIPointer(k, -size, gl.UNSIGNED_INT, 4 * each, 4 * first);
      return first + Math.abs(size);
    }, 0);
    return {vertices, data, count: numbers.length / each};
  }
  drop({vertices, data}) {
    this.gl.deleteVertexArray(vertices);
    this.gl.deleteBuffer(data);
  }
  // Draws a buffer, or those of its vertices that are in a list, by a program with those of the uniforms that it has.
  draw(name, uniforms, buffer, kind = "TRIANGLES", list = null) {
    const {gl} = this, {program, set} = this.programs[name] ??= this.linked(name);
    gl.useProgram(program);
    for (const name in uniforms) set[name]?.(uniforms[name]);
    gl.bindVertexArray(buffer.vertices);
    if (!list) { gl.drawArrays(gl[kind], 0, buffer.count); return; }
    if (!buffer.list) gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer.list = gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, list, gl.DYNAMIC_DRAW);
    gl.drawElements(gl[kind], list.length, gl.UNSIGNED_INT, 0);
  }
  // Read texel by texel, but for colours; `data` may be null. Of several layers where they are given.
  texture(format, width, height, data, layers) {
    const {gl} = this, texture = gl.createTexture(), kind = layers ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D;
    const [outside, type] = texels[format].map((name) => gl[name]), size = [width, height, ...(layers ? [layers] : [])];
    gl.bindTexture(kind, texture);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
      gl.texParameteri(kind, filter, format === "RGBA8" ? gl.LINEAR : gl.NEAREST);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl[layers ? "texImage3D" : "texImage2D"](kind, 0, gl[format], ...size, 0, outside, type, data);
    return texture;
  }
  // A framebuffer of a texture's layer, with depth where that is given.
  target(texture, layer, depth) {
    const {gl} = this, target = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
    gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, texture, 0, layer);
    if (depth) gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
    return target;
  }
}
