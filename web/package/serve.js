// SPDX-License-Identifier: MIT
// serve.js - what a worker does: jobs come as messages, and each gets one message back.
import {startModule} from "./module.js";
import {line, parsed} from "./requests.js";

/** @param send  Sends a message to the client. @return  Takes a message of the client. */
export function serve(send) {
  let started;
  const answer = async ({kind, name, bytes, request}) => {
    const module = await started;
    if (kind === "read") return parsed(kind, module.read(name, bytes));
    return parsed(kind, module.answer(kind, line(request)));
  };
  return async job => {
    if (job.kind === "start") return void (started = startModule(job.wasm));
    try {
      const found = await answer(job);
      // Out of memory: what its calls held is lost.
      send({id: job.id, ended: found.error?.code === "stopped", answer: found});
    } catch (error) {
      // After a trap the module is in no known state. In both cases the client ends this worker.
      const isFault = error.kind !== undefined;
      send({id: job.id, ended: !isFault, answer: {error: {code: error.kind ?? "internal", message: String(error.message ?? error)}}});
    }
  };
}
