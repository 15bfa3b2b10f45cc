// SPDX-License-Identifier: MIT
// module.js - the WebAssembly module: texts in, texts out. It knows neither files nor the network nor threads.

const kNotHere = 52;  // ENOSYS, as WASI says it

// What the module imports. It asks for the time of its stages; what the C library asks for besides, files say, is not here.
function importsOf(compiled, memory) {
  const view = () => new DataView(memory().buffer);
  const known = {
    clock_time_get: (clock, precision, at) => {
      view().setBigUint64(at >>> 0, BigInt(Math.round((clock === 0 ? Date.now() : performance.now()) * 1e6)), true);
      return 0;
    },
    environ_sizes_get: (count, size) => {
      view().setUint32(count >>> 0, 0, true);
      view().setUint32(size >>> 0, 0, true);
      return 0;
    },
    proc_exit: code => { throw new Error(`the module ended with ${code}`); },
  };
  const imports = {};
  for (const {module, name, kind} of WebAssembly.Module.imports(compiled)) {
    if (kind === "function") (imports[module] ??= {})[name] = known[name] ?? (() => kNotHere);
  }
  return imports;
}

/** A module, started. @param wasm  Its bytes, or the compiled module. */
export async function startModule(wasm) {
  const compiled = wasm instanceof WebAssembly.Module ? wasm : await WebAssembly.compile(wasm);
  let exports;
  exports = (await WebAssembly.instantiate(compiled, importsOf(compiled, () => exports.memory))).exports;
  exports._initialize();

  const refuse = sentence => ({error: {code: "stopped", message: sentence}});
  // A copy of the bytes in the module's memory, with a 0 behind them; 0 if there is no room.
  const keep = bytes => {
    const at = exports.malloc(bytes.length + 1) >>> 0;
    if (at === 0) return 0;
    new Uint8Array(exports.memory.buffer).set(bytes, at);
    new Uint8Array(exports.memory.buffer)[at + bytes.length] = 0;
    return at;
  };
  const call = (entry, word, bytes) => {
    const first = keep(new TextEncoder().encode(word)), second = keep(bytes);
    if (first === 0 || second === 0) return refuse("out of memory: the request does not fit");
    entry(first, second, bytes.length);
    exports.free(first);
    exports.free(second);
    const from = exports.convexact_text() >>> 0;
    return new TextDecoder().decode(new Uint8Array(exports.memory.buffer, from, exports.convexact_size() >>> 0));
  };
  return {
    /** The answer to a request of a kind, as `convexact KIND --stdio` gives it: a line of JSON; or an object with an error. */
    answer: (kind, line) => call(exports.convexact_answer, kind, new TextEncoder().encode(line)),
    /** The shape in a file, as a request has it. */
    read: (name, bytes) => call(exports.convexact_read, name, bytes),
    /** Bytes that the module holds now. It never gives any back. */
    memory: () => exports.memory.buffer.byteLength,
  };
}
