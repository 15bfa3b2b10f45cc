// SPDX-License-Identifier: MIT
// browser.js - the package in a browser and in bundlers.
import {Convexact} from "./client.js";
export {ConvexactError} from "./client.js";
export {toNumber} from "./requests.js";

function startWorker(take, fail) {
  const worker = new Worker(new URL("./worker.js", import.meta.url), {type: "module"});
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
