// SPDX-License-Identifier: GPL-2.0-or-later
// Scripts that tests add to a page of `flatdyn report`, to use it like a person and to report what it shows.
#pragma once

namespace flatdyn::testing {

// Runs before everything else on the page and records errors.
inline constexpr const char* kBefore = R"js(<script>
window.troubles = [];
addEventListener('error', (event) => troubles.push(String(event.message)));
addEventListener('securitypolicyviolation', (event) => troubles.push('blocked ' + event.blockedURI));
console.error = console.warn = (...words) => troubles.push(words.join(' '));
</script>)js";

// Runs after the page and moves every slider of every kind.
inline constexpr const char* kMove = R"js(<script>
const kinds = [...document.querySelectorAll('input[name=kind]')];
for (const kind of kinds) {
  kind.click();
  document.querySelectorAll('#sliders input[type=range]').forEach((range, k) => {
    const part = 0.5 + 0.37 * Math.sin(1 + 3 * k + 7 * kinds.indexOf(kind));
    range.value = Number(range.min) + part * (Number(range.max) - Number(range.min));
    range.dispatchEvent(new Event('input'));
  });
}
document.querySelectorAll('#symbols input').forEach((field, k) => {
  field.value = 0.3 + 0.07 * k;
  field.dispatchEvent(new Event('input'));
});
</script>)js";

inline constexpr const char* kRead = R"js(<script>
const values = (prefix) => [...document.querySelectorAll(`[id^="${prefix}"][data-value]`)].map((cell) => Number(cell.dataset.value));
const numbers = (text) => text.split(' ').map(Number);
const read = () => ({
  csv: document.getElementById('csv').value, tau: values('tau-'), g: values('g-'), B: values('B-'),
  axes: numbers(document.getElementById('ellipsoid-text').dataset.axes),
  centre: numbers(document.getElementById('ellipsoid-text').dataset.centre),
  drawn: document.querySelectorAll('#view line, #view ellipse').length,
});
</script>)js";

// Uses every control, and plays a motion for a while.
inline constexpr const char* kUse = R"js(<script>
const press = (id) => document.getElementById(id).click();
const picture = () => document.getElementById('view').innerHTML;
const key = (name) => document.getElementById('view').dispatchEvent(new KeyboardEvent('keydown', {key: name, cancelable: true}));
const changes = (look, use) => { const before = look(); use(); return look() !== before; };
const csv = () => document.getElementById('csv').value;
const used = {
  left: changes(picture, () => key('ArrowLeft')), up: changes(picture, () => key('ArrowUp')),
  larger: changes(picture, () => key('+')), reset: changes(picture, () => press('view-reset')),
  middle: changes(csv, () => press('middle')), random: changes(csv, () => press('random')), start: changes(csv, () => press('start')),
  unit: changes(() => document.getElementById('ellipsoid-text').textContent, () => document.querySelector('[value=unit]').click()),
  hides: changes(() => document.querySelectorAll('.shell').length, () => press('ellipsoid')),
  theme: changes(() => getComputedStyle(document.body).backgroundColor, () => press('theme')),
  typed: changes(csv, () => {
    const field = document.querySelector('#sliders input[type=number]');
    field.value = '0.123';
    field.dispatchEvent(new Event('input'));
  }),
  nonsense: !changes(csv, () => {
    const field = document.querySelector('#sliders input[type=number]');
    field.value = '';
    field.dispatchEvent(new Event('input'));
  }),
};
press('play');
var later = 700;
</script>)js";

inline constexpr const char* kCheck = R"js(<script>
const named = (control) => control.labels?.length > 0 || control.hasAttribute('aria-label') || control.textContent.trim() !== '';
const seen = () => ({
  troubles, fetched: performance.getEntriesByType('resource').map((entry) => entry.name),
  unnamed: [...document.querySelectorAll('input, button, textarea, select')].filter((control) => !named(control)).length,
  pictures: [...document.querySelectorAll('svg')].filter((svg) => svg.getAttribute('role') !== 'img' || !svg.getAttribute('aria-label')).length,
  ids: document.querySelectorAll('[id]').length - new Set([...document.querySelectorAll('[id]')].map((element) => element.id)).size,
  heads: [...document.querySelectorAll('th')].filter((head) => !head.hasAttribute('scope')).length,
  landmarks: ['header', 'nav', 'main', 'footer'].map((name) => document.querySelectorAll(name).length),
  trouble: document.getElementById('trouble').hidden ? '' : document.getElementById('trouble').textContent,
  images: document.images.length, title: document.title, heading: document.querySelector('h1').textContent,
  names: [...document.querySelectorAll('#torques th')].map((head) => head.textContent),
  wide: document.documentElement.scrollWidth - document.documentElement.clientWidth,
});
</script>)js";

inline constexpr const char* kTell = R"js(<script>
const told = document.createElement('pre');
told.id = 'told';
const tell = () => {
  const all = {...seen(), ...(typeof read === 'function' ? read() : {}), ...(typeof used === 'object' ? used : {})};
  told.textContent = btoa(String.fromCharCode(...new TextEncoder().encode(JSON.stringify(all))));
  document.body.append(told);
  parent.postMessage(told.textContent, '*');
};
if (window.later) setTimeout(() => { document.getElementById(window.stopper ?? 'play').click(); tell(); }, later); else tell();
</script>)js";

}  // namespace flatdyn::testing
