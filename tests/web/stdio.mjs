// SPDX-License-Identifier: MIT
// stdio.mjs PROGRAM WEB KIND - the module as the program with --stdio: answers on standard output to the lines of standard
// input. For times.py, which starts either.
import {readFileSync} from "node:fs";
import {startedModule} from "./support.mjs";

const module = await startedModule();
for (const line of readFileSync(0, "utf8").split("\n")) {
  if (line.trim() !== "") process.stdout.write(`${module.answer(process.argv[4], line)}\n`);
}
