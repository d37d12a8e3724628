// What is drawn with: the page's WebGL 2, programs of its shaders, buffers and textures.
class Tools {
  constructor(canvas, shaders, live) {
    const wish = {antialias: true, alpha: true, premultipliedAlpha: true, preserveDrawingBuffer: true, failIfMajorPerformanceCaveat: live};
    // Where the processor draws, smooth edges cost as much as the rest.
    this.gl = canvas.getContext("webgl2", wish) ?? canvas.getContext("webgl2", {...wish, antialias: false, failIfMajorPerformanceCaveat: false});
    if (!this.gl) throw new Error("no WebGL 2");
    this.shaders = shaders;
  }
  // With the places of its uniforms by their names.
  program(name) {
    const gl = this.gl, program = gl.createProgram();
    this.shaders[name].forEach((text, k) => {
      const shader = gl.createShader(k ? gl.FRAGMENT_SHADER : gl.VERTEX_SHADER);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(name + ": " + gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    });
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(name + ": " + gl.getProgramInfoLog(program));
    return new Proxy({program}, {get: (known, name) => known[name] ?? (known[name] = gl.getUniformLocation(program, name))});
  }
  // Vertices of so many floats each, three an attribute.
  buffer(numbers, floats) {
    const gl = this.gl, vertices = gl.createVertexArray(), data = gl.createBuffer();
    gl.bindVertexArray(vertices);
    gl.bindBuffer(gl.ARRAY_BUFFER, data);
    gl.bufferData(gl.ARRAY_BUFFER, numbers instanceof Float32Array ? numbers : new Float32Array(numbers), gl.STATIC_DRAW);
    for (let k = 0; k < floats / 3; ++k) {
      gl.enableVertexAttribArray(k);
      gl.vertexAttribPointer(k, 3, gl.FLOAT, false, 4 * floats, 12 * k);
    }
    return {vertices, data, count: numbers.length / floats};
  }
  drop({vertices, data}) {
    this.gl.deleteVertexArray(vertices);
    this.gl.deleteBuffer(data);
  }
  refill(buffer, numbers, floats) {
    const gl = this.gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer.data);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(numbers), gl.DYNAMIC_DRAW);
    buffer.count = numbers.length / floats;
  }
  // Of the format, read texel by texel; `data` may be null.
  texture([inside, format, type], width, height, data) {
    const gl = this.gl, texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl[inside], width, height, 0, gl[format], gl[type], data);
    return texture;
  }
  // A framebuffer of a texture, or of a layer of it, with depth where that is given.
  target(texture, layer, depth) {
    const gl = this.gl, made = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, made);
    if (layer === undefined) gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    else gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, texture, 0, layer);
    if (depth) gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
    if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE) throw new Error("no framebuffer for maps");
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return made;
  }
  bind(place, location, texture, kind) {
    const gl = this.gl;
    gl.activeTexture(gl.TEXTURE0 + place);
    gl.bindTexture(kind ?? gl.TEXTURE_2D, texture);
    gl.uniform1i(location, place);
    gl.activeTexture(gl.TEXTURE0);
  }
}
