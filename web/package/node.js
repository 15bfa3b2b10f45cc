// SPDX-License-Identifier: MIT
// node.js - the package in Node.
import {readFile} from "node:fs/promises";
import {Worker} from "node:worker_threads";
import {Convexact} from "./client.js";
export {ConvexactError} from "./client.js";
export {toNumber} from "./requests.js";

function startWorker(take, fail) {
  const worker = new Worker(new URL("./node-worker.js", import.meta.url));
  worker.on("message", take);
  worker.on("error", error => fail(error.message));
  return {
    send: message => worker.postMessage(message),
    end: () => worker.terminate(),
    // A program ends when nothing is asked any more.
    wait: isAsked => isAsked ? worker.ref() : worker.unref(),
  };
}

const load = async name => new Uint8Array(await readFile(new URL(name, import.meta.url)));

export default function convexact() {
  return Convexact.start(startWorker, load);
}
