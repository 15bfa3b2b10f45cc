// SPDX-License-Identifier: MIT
// links.js - links to the other lessons, where they can be reached: beside this one, if ./dev lessons put it there, and on
// the page of convexact, which makes a lesson when it is asked for. Elsewhere their names stand alone.
"use strict";

// The page shows a lesson in a frame, under the address of a blob.
const isOnPage = location.protocol === "blob:" && parent !== window;
const hasOthers = isOnPage || document.documentElement.hasAttribute("data-others");

// @param at  A file, and a step of it: polygon.html#polar.
const toLesson = (at, words) => hasOthers ? `<a href="${at}">${words}</a>` : words;
for (const link of document.querySelectorAll("[data-lesson]")) link.outerHTML = toLesson(link.dataset.lesson, link.innerHTML);

// The frame may load nothing, not even a step of its own address, which it may only say that it is at.
if (isOnPage) addEventListener("click", event => {
  const at = event.target.closest?.("a")?.getAttribute("href");
  if (!at) return;
  event.preventDefault();
  if (!at.startsWith("#")) return parent.postMessage({lesson: at}, "*");
  history.replaceState(null, "", at);
  dispatchEvent(new Event("hashchange"));
});
