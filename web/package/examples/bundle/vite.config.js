// SPDX-License-Identifier: MIT
export default {
  base: "./",
  build: {target: "es2022"},  // a module may wait at its top
  worker: {format: "es"},
  // The development server would bundle the package into one file, and the worker would be missing.
  optimizeDeps: {exclude: ["convexact"]},
};
