// SPDX-License-Identifier: MIT
// client.js - the side of the caller: one worker, to which jobs go one after another.
import {conform} from "./conform.js";

/** An answer that is an error: its kind, the line or row at fault if there is one, and a sentence. */
export class ConvexactError extends Error {
  constructor({code, message, line, proof}) {
    super(message);
    this.name = "ConvexactError";
    this.kind = code;
    this.sentence = message;
    if (line !== undefined) this.line = line;
    if (proof !== undefined) this.proof = proof;
  }
}

export class Convexact {
  #startWorker;
  #load;
  #wasm;
  #worker;
  #jobs = new Map();
  #number = 0;

  static async start(startWorker, load) {
    const made = new Convexact();
    made.#startWorker = startWorker;
    made.#load = load;
    // Compiled once: a worker that takes the place of another one starts at once.
    made.#wasm = await WebAssembly.compile(await load("convexact.wasm"));
    return made;
  }

  /** The exact hull of points, or the solid that halfspaces bound. */
  hull(shape, options) { return this.#ask("hull", {shape, options}); }
  /** Few halfspaces that hold everything. */
  simplify(shape, options) { return this.#ask("simplify", {shape, options}); }
  /** Whether a candidate is what it is asked to be. */
  verify(shape, candidate, options) { return this.#ask("verify", {shape, candidate, options}); }
  /** Few convex parts that hold a solid. */
  decompose(mesh, options) { return this.#ask("decompose", {shape: mesh, options}); }
  /** The construction of a shape step by step, as a page. */
  teach(shape, options) { return this.#ask("teach", {shape, options}); }
  /** The shape in the bytes of a file. */
  read(bytes, name) { return this.#send({kind: "read", name, bytes}); }
  /** Judges a function over inputs with known answers. */
  async conform(program, options) {
    const vectors = JSON.parse(new TextDecoder().decode(await this.#load("vectors.json")));
    return conform(this, vectors, program, options);
  }

  /** Ends the worker. What was asked and not answered is an error of the kind "stopped"; what is asked next gets a new worker. */
  cancel() { this.#end({code: "stopped", message: "cancelled"}); }

  #ask(kind, request) { return this.#send({kind, request}); }

  #send(job) {
    this.#worker ??= this.#start();
    const id = ++this.#number;
    this.#worker.wait?.(true);
    return new Promise((resolve, reject) => {
      this.#jobs.set(id, {resolve, reject});
      try {
        this.#worker.send({...job, id});
      } catch (error) {  // such as a function among the options
        this.#jobs.delete(id);
        reject(new ConvexactError({code: "invalid-argument", message: error.message}));
      }
    });
  }

  #start() {
    const worker = this.#startWorker(
      message => this.#worker === worker && this.#take(message),
      sentence => this.#worker === worker && this.#end({code: "internal", message: sentence}));
    worker.send({kind: "start", wasm: this.#wasm});
    return worker;
  }

  #take({id, answer, ended}) {
    const job = this.#jobs.get(id);
    if (job) {
      this.#jobs.delete(id);
      if (answer?.error) job.reject(new ConvexactError(answer.error)); else job.resolve(answer);
    }
    if (ended) return this.#end({code: "stopped", message: "the module ended in another job"});
    if (this.#jobs.size === 0) this.#worker.wait?.(false);
  }

  #end(error) {
    this.#worker?.end();
    this.#worker = undefined;
    const jobs = [...this.#jobs.values()];
    this.#jobs.clear();
    for (const job of jobs) job.reject(new ConvexactError(error));
  }
}
