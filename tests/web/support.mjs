// SPDX-License-Identifier: MIT
// support.mjs - what the tests share: the arguments, the shipped data, the module without its worker.
import {readFileSync} from "node:fs";
import {fileURLToPath, pathToFileURL} from "node:url";

export const [program, web] = process.argv.slice(2);
export const folder = fileURLToPath(new URL("..", import.meta.url));  // tests/
export const data = name => readFileSync(`${folder}${name}`);
export const packaged = name => import(pathToFileURL(`${web}/package/${name}`));

export async function startedModule() {
  const {startModule} = await packaged("module.js");
  return startModule(readFileSync(`${web}/package/convexact.wasm`));
}

/** Vectors of a file, as it spells them. */
export const vectors = name => JSON.parse(data(`vectors/${name}.json`)).vectors;

/** Random numbers below 1, the same in each run [xorshift of 32 bits]. */
export function random(seed) {
  return () => {
    seed ^= seed << 13;
    seed ^= seed >>> 17;
    seed ^= seed << 5;
    return (seed >>> 0) / 4294967296;
  };
}

export const skip = why => { console.log(`skipped: ${why}`); process.exit(77); };
