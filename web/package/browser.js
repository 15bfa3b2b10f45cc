// SPDX-License-Identifier: MIT
// browser.js - the package in a browser and in bundlers.
import {Convexact} from "./client.js";
export {ConvexactError} from "./client.js";
export {toNumber} from "./requests.js";

function newWorker() {
  try {
    return new Worker(new URL("./worker.js", import.meta.url), {type: "module"});
  } catch (error) {
    if (error.name !== "SecurityError") throw error;
    // A page takes workers from its own origin only, but one of its own may import another's.
    const from = new URL("worker.js", import.meta.url.replace(/[^/]*$/, "")), text = `import ${JSON.stringify(from.href)};`;
    const url = URL.createObjectURL(new Blob([text], {type: "text/javascript"}));
    return new Worker(url, {type: "module"});
  }
}

function startWorker(take, fail) {
  const worker = newWorker();
  worker.onmessage = event => take(event.data);
  worker.onerror = event => fail(event.message ?? "the worker cannot be started");
  return {send: message => worker.postMessage(message), end: () => worker.terminate()};
}

async function load(name) {
  // Spelled out, so that bundlers find both files.
  const urls = {"convexact.wasm": new URL("./convexact.wasm", import.meta.url), "vectors.json": new URL("./vectors.json", import.meta.url)};
  const response = await fetch(urls[name]);
  if (!response.ok) throw new Error(`${urls[name]}: ${response.status}`);
  return new Uint8Array(await response.arrayBuffer());
}

export default function convexact() {
  return Convexact.start(startWorker, load);
}
