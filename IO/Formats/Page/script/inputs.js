// What the writer put in: numbers, the library and the picture.

function bytesOf(id) {
  const text = atob(element(id).textContent.trim());
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) {
    bytes[i] = text.charCodeAt(i);
  }
  return bytes;
}

async function inflated(id) {
  const stream = new Blob([bytesOf(id)]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Codes of a width of bytes: differences with the sign as the lowest bit, lowest bytes first.
function codeReader(bytes) {
  let at = 0;
  return (count, width) => {
    const codes = new Uint32Array(count);
    const mask = width === 4 ? 0xffffffff : (1 << (8 * width)) - 1;
    let code = 0;
    for (let i = 0; i < count; ++i) {
      let folded = 0;
      for (let b = 0; b < width; ++b) {
        folded |= bytes[at + b * count + i] << (8 * b);
      }
      code = (code + ((folded >>> 1) ^ -(folded & 1))) & mask;
      codes[i] = code;
    }
    at += width * count;
    return codes;
  };
}

// The library, in a scope of its own. It exports as a CommonJS module does.
function loadThree(source) {
  const script = document.createElement("script");
  script.textContent = "(function (exports, module) {" + source + "\n})(window.page.three = {}, {});";
  document.head.append(script);
  const library = window.page.three;
  delete window.page.three;
  return library;
}

async function loadPicture() {
  const image = new Image();
  image.src = "data:image/jpeg;base64," + element("picture").textContent.trim();
  await image.decode();
  return image;
}
