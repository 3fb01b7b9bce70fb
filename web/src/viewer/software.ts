// Whether pictures are drawn by the processor, for want of a graphics card.

/** Smoothing by four samples a pixel costs a processor four times the time: it goes without. */
export function drawsInSoftware(): boolean {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return false;
  let name = String(gl.getParameter(gl.RENDERER));
  // Some browsers tell only when asked in this way, and others warn of it.
  if (/^webkit/i.test(name)) {
    const names = gl.getExtension('WEBGL_debug_renderer_info');
    if (names) name = String(gl.getParameter(names.UNMASKED_RENDERER_WEBGL));
  }
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|basic render|software/i.test(name);
}
