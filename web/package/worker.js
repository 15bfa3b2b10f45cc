// SPDX-License-Identifier: MIT
// worker.js - the worker in a browser.
import {serve} from "./serve.js";

const take = serve(message => self.postMessage(message));
self.onmessage = event => take(event.data);
