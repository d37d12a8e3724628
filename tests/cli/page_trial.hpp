// A report's page in a browser, used as a reader would: what of its picture changes, and that it comes back.
#pragma once

#include <gtest/gtest.h>

#include "support/browser.hpp"

namespace moldlight::test {

/// Pixels that each act changes, in the page's own terms; `begun` is what its scripts begin with.
inline constexpr const char* k_page_trial = R"js(begun.then((view) => {
  const pixels = () => {
    view.draw();
    const {gl, canvas} = view, bytes = new Uint8Array(4 * canvas.width * canvas.height);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return new Uint32Array(bytes.buffer);
  };
  const differing = (a, b) => a.reduce((sum, pixel, k) => sum + (pixel !== b[k] ? 1 : 0), 0);
  const use = (name, value) => {
    const input = view.figure.querySelector("#" + name);
    input.value = value;
    input.dispatchEvent(new Event(input.tagName === "SELECT" ? "change" : "input"));
  };
  const first = pixels(), found = {pixels: first.length, drawn: first.filter((pixel) => pixel).length,
    colours: new Set(first).size};
  const compare = (name, act, back) => { act(); found[name] = differing(first, pixels()); back(); };
  const key = (name) => view.canvas.dispatchEvent(new KeyboardEvent("keydown", {key: name}));
  compare("turned", () => key("ArrowLeft"), () => key("ArrowRight"));
  compare("opened", () => use("open", view.opened > 0.5 ? 0 : 1), () => use("open", view.model.opened));
  compare("cleared", () => use("clear", 0.7), () => use("clear", 0));
  compare("cut", () => use("plane", "d"), () => use("plane", ""));
  const boxes = [...view.figure.querySelectorAll("input[data-group]")].filter((box) => box.checked);
  compare("hidden", () => boxes.forEach((box) => box.click()), () => boxes.forEach((box) => box.click()));
  view.home();
  return {...found, restored: differing(first, pixels()), glError: view.gl.getError(),
    controls: view.figure.querySelector("#open").offsetParent !== null,
    requests: performance.getEntriesByType("resource").length,
    width: document.documentElement.scrollWidth, room: document.documentElement.clientWidth};
}))js";

/// Fails where the loaded page does not turn, open, let through, cut and hide the part, keeps not to itself
/// or breaks its own policy.
inline Browser::Json try_page(Browser& browser) {
  const Browser::Json found = browser.value(k_page_trial);
  EXPECT_TRUE(browser.messages().empty()) << browser.messages().front();
  EXPECT_EQ(browser.requests(), 0u);
  EXPECT_EQ(found["requests"], 0);
  EXPECT_EQ(found["glError"], 0);
  EXPECT_EQ(found["controls"], true);
  for (const char* act : {"turned", "opened", "cleared", "cut", "hidden"})
    EXPECT_GT(found[act], 0.01 * found["pixels"].get<double>()) << act << " in " << found;
  EXPECT_LE(found["width"], found["room"]) << "nothing sticks out at the side";
  return found;
}

}  // namespace moldlight::test
