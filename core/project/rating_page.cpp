#include "core/project/rating_page.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/motion/blend.h"
#include "core/motion/pose.h"

namespace kumite {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kRate = 30;

/// Bones as pairs of joints; left ones apart, because they are drawn darker.
Json bonesOf(const Rig& rig) {
    Json bones = Json::array();
    for (int joint = 1; joint < rig.jointCount(); ++joint) {
        const bool left = rig.joint(joint).name.find("eft") != std::string::npos ||
                          (rig.joint(joint).name.size() > 1 && rig.joint(joint).name[0] == 'l' &&
                           rig.joint(joint).name[1] >= 'A' && rig.joint(joint).name[1] <= 'Z');
        bones.push_back({rig.joint(joint).parent, joint, left ? 1 : 0});
    }
    return bones;
}

/// Places of all joints frame by frame, whole centimetres.
Json framesOf(const Clip& clip) {
    Json frames = Json::array();
    const int count = std::max(2, static_cast<int>(std::lround(clip.seconds() * kRate)) + 1);
    JointFrames places;
    for (int f = 0; f < count; ++f) {
        jointFrames(*clip.rig, poseAt(clip, std::min(f / kRate, clip.seconds())), places);
        Json row = Json::array();
        for (const Eigen::Vector3d& place : places.positions) {
            for (int axis = 0; axis < 3; ++axis)
                row.push_back(std::lround(100 * place[axis]));
        }
        frames.push_back(std::move(row));
    }
    return frames;
}

/// Hides a text from somebody who reads the page; it is no secret.
std::string scrambled(const std::string& text) {
    static constexpr char kDigits[] = "0123456789abcdef";
    std::string hidden;
    unsigned key = 0x5a;
    for (const char letter : text) {
        const unsigned byte = static_cast<unsigned char>(letter) ^ key;
        hidden += kDigits[byte >> 4];
        hidden += kDigits[byte & 15];
        key = (key * 29 + 17) & 0xff;
    }
    return hidden;
}

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char letter : text) {
        if (letter == '<') {
            safe += "&lt;";
        } else if (letter == '&') {
            safe += "&amp;";
        } else {
            safe += letter;
        }
    }
    return safe;
}

constexpr const char* kHead = R"page(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>TITLE</title><style>
body { font: 16px/1.5 sans-serif; max-width: 760px; margin: 24px auto; padding: 0 16px;
  color: #22252a; background: #fff; }
canvas { width: 100%; background: #f3f4f6; border-radius: 6px; }
button { font: inherit; padding: 8px 20px; margin-right: 8px; border: 1px solid #8a8f98;
  border-radius: 4px; background: #fff; cursor: pointer; }
button:focus-visible { outline: 3px solid #0072b2; }
table { border-collapse: collapse; } td, th { padding: 4px 16px 4px 0; text-align: left; }
td + td { text-align: right; font-variant-numeric: tabular-nums; }
@media (prefers-color-scheme: dark) { body { color: #e6e8eb; background: #1d1f23; }
  canvas { background: #26282d; } button { background: #26282d; color: inherit; } }
</style></head><body><h1>TITLE</h1>
<div id="ask"><p>Does this motion look as if a person had made it? Look as often as you like.</p>
<canvas id="view" width="1440" height="900" role="img" aria-label="A moving figure"></canvas>
<p><button id="yes">Natural (→)</button><button id="no">Not natural (←)</button>
<button id="back">Back (Backspace)</button> <span id="count"></span></p></div>
<div id="end" hidden><h2>Result</h2><table id="table"></table>
<p><a id="save" download="ratings.csv"><button>Save the answers</button></a></p></div>
<script>
"use strict";
const data = )page";

constexpr const char* kTail = R"page(;
const answers = [];
let start = performance.now();
const get = id => document.getElementById(id);
function plain(hidden) {
  let key = 0x5a, bytes = [];
  for (let i = 0; i < hidden.length; i += 2) {
    bytes.push(parseInt(hidden.substr(i, 2), 16) ^ key);
    key = (key * 29 + 17) & 0xff;
  }
  return new TextDecoder().decode(new Uint8Array(bytes));
}
function wilson(natural, count) {
  if (count === 0) return [0, 1];
  const z = 1.959964, p = natural / count, d = 1 + z * z / count;
  const middle = (p + z * z / (2 * count)) / d;
  const half = z * Math.sqrt(p * (1 - p) / count + z * z / (4 * count * count)) / d;
  return [Math.max(0, middle - half), Math.min(1, middle + half)];
}
function results() {
  const kinds = new Map();
  answers.forEach((natural, i) => {
    const kind = plain(data.clips[i].kind);
    const row = kinds.get(kind) || [0, 0];
    row[0] += natural ? 1 : 0;
    row[1] += 1;
    kinds.set(kind, row);
  });
  return [...kinds].sort();
}
function csv() {
  const quoted = text => '"' + text.replaceAll('"', '""') + '"';
  return ["place,kind,name,natural", ...answers.map((natural, i) =>
    [i + 1, quoted(plain(data.clips[i].kind)), quoted(plain(data.clips[i].name)),
     natural ? 1 : 0].join(","))].join("\n") + "\n";
}
function finish() {
  get("ask").hidden = true;
  get("end").hidden = false;
  const percent = share => (100 * share).toFixed(0) + " %";
  let rows = "<tr><th>kind</th><th>rated</th><th>natural</th><th>95 % interval</th></tr>";
  for (const [kind, [natural, count]] of results()) {
    const [low, high] = wilson(natural, count);
    rows += `<tr><td>${kind}</td><td>${count}</td><td>${percent(natural / count)}</td>` +
      `<td>${percent(low)} to ${percent(high)}</td></tr>`;
  }
  get("table").innerHTML = rows;
  get("save").href = URL.createObjectURL(new Blob([csv()], {type: "text/csv"}));
}
function answer(natural) {
  if (answers.length >= data.clips.length) return;
  answers.push(natural);
  start = performance.now();
  if (answers.length === data.clips.length) finish();
}
function back() {
  if (answers.length === 0 || answers.length === data.clips.length) return;
  answers.pop();
  start = performance.now();
}
// From the front at three quarters, a little from above.
function seen(x, y, z) {
  const a = 0.6, b = 0.15, far = 420;
  const right = x * Math.cos(a) - z * Math.sin(a), ahead = x * Math.sin(a) + z * Math.cos(a);
  const up = y - 90;
  const depth = far - (ahead * Math.cos(b) + up * Math.sin(b));
  const scale = 1500 / Math.max(60, depth);
  return [720 + right * scale, 450 - (up * Math.cos(b) - ahead * Math.sin(b)) * scale];
}
function draw(now) {
  const context = get("view").getContext("2d");
  context.clearRect(0, 0, 1440, 900);
  const clip = data.clips[Math.min(answers.length, data.clips.length - 1)];
  get("count").textContent = `${answers.length + 1} of ${data.clips.length}`;
  const dark = matchMedia("(prefers-color-scheme: dark)").matches;
  context.lineCap = "round";
  context.strokeStyle = dark ? "#3a3d44" : "#d5d8dd";
  context.lineWidth = 2;
  for (let k = -200; k <= 200; k += 50) {
    for (const [p, q] of [[[k, -200], [k, 200]], [[-200, k], [200, k]]]) {
      context.beginPath();
      context.moveTo(...seen(p[0], 0, p[1]));
      context.lineTo(...seen(q[0], 0, q[1]));
      context.stroke();
    }
  }
  // Half a second of rest between two rounds.
  const length = clip.frames.length - 1;
  const at = Math.min(length, ((now - start) / 1000 * data.rate) % (length + data.rate / 2));
  const first = clip.frames[Math.floor(at)], next = clip.frames[Math.min(length, Math.ceil(at))];
  const share = at - Math.floor(at);
  const place = j => seen(...[0, 1, 2].map(c =>
    first[3 * j + c] * (1 - share) + next[3 * j + c] * share));
  for (const [from, to, left] of data.bones) {
    context.strokeStyle = left ? (dark ? "#3f8fc0" : "#004f7d") : (dark ? "#56b4e9" : "#3f95c5");
    context.lineWidth = 16;
    context.beginPath();
    context.moveTo(...place(from));
    context.lineTo(...place(to));
    context.stroke();
  }
  requestAnimationFrame(draw);
}
get("yes").onclick = () => answer(true);
get("no").onclick = () => answer(false);
get("back").onclick = back;
document.addEventListener("keydown", event => {
  if (event.key === "ArrowRight") answer(true);
  else if (event.key === "ArrowLeft") answer(false);
  else if (event.key === "Backspace") back();
});
requestAnimationFrame(draw);
</script></body></html>
)page";

std::string withTitle(std::string text, const std::string& title) {
    for (std::size_t at = 0; (at = text.find("TITLE", at)) != std::string::npos; at += title.size())
        text.replace(at, 5, title);
    return text;
}

}  // namespace

std::pair<double, double> wilsonInterval(int natural, int count) {
    if (count <= 0) return {0, 1};
    constexpr double z = 1.959964;
    const double n = count, p = natural / n, d = 1 + z * z / n;
    const double middle = (p + z * z / (2 * n)) / d;
    const double half = z * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n)) / d;
    return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

std::string ratingPage(const std::vector<RatedClip>& clips, const std::string& title,
                       std::uint32_t seed) {
    if (clips.empty()) throw Error("There is no clip to rate.");
    std::mt19937 random(seed);
    const std::vector<int> order = drawnOrder(clips.size(), random);
    Json data = {{"rate", kRate}, {"bones", bonesOf(*clips.front().clip.rig)}};
    Json& list = data["clips"] = Json::array();
    for (const int i : order) {
        const RatedClip& clip = clips[static_cast<std::size_t>(i)];
        list.push_back({{"kind", scrambled(clip.kind)},
                        {"name", scrambled(clip.name)},
                        {"frames", framesOf(clip.clip)}});
    }
    return withTitle(kHead, escaped(title)) + data.dump() + kTail;
}

}  // namespace kumite
