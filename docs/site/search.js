// The search of the site, in `search.html`: lunr on the index that MkDocs makes of every section.
/* global lunr, searched, base_url */

/** Letters of a section that are shown, and of them those before the first match. */
const [SHOWN, BEFORE] = [240, 60];

/** A script of the site; the library and the index are loaded where one searches, and nowhere else. */
const load = (name) => new Promise((done, failed) => {
  const script = document.createElement("script");
  Object.assign(script, { src: `${base_url}/search/${name}`, onload: done, onerror: failed });
  document.head.append(script);
});

/** The sections by where they are, and what finds them; a page as a whole is in the list too, with the text of all of its sections. */
function indexed() {
  const titles = new Map(searched.docs.map(({ location, title }) => [location, title]));
  const sections = new Map(searched.docs.filter(({ location }) => location.includes("#")).map((section) => {
    const page = titles.get(section.location.split("#")[0]);
    return [section.location, { ...section, heading: page === section.title ? page : `${page}: ${section.title}` }];
  }));
  // A name such as `environment.wall.stiffness` is found by each of its words.
  lunr.tokenizer.separator = /[^\p{L}\p{N}]+/u;
  const index = lunr(function () {
    this.ref("location");
    this.field("title", { boost: 10 });
    this.field("text");
    this.metadataWhitelist = ["position"];
    for (const section of sections.values()) this.add(section, { boost: section.location.startsWith("decisions/") ? 0.5 : 1 });
  });
  return [index, sections];
}

/** The sections that have every word, or a longer one that begins with it; whole words first. */
function search(index, asked) {
  const { presence: { REQUIRED }, wildcard: { TRAILING } } = lunr.Query;
  const words = lunr.tokenizer(asked).filter((word) => String(word) && lunr.stopWordFilter(word));
  return words.length === 0 ? [] : index.query((query) => {
    for (const word of words) {
      query.term(lunr.stemmer(word.clone()), { presence: REQUIRED, wildcard: TRAILING, usePipeline: false });
      query.term(word, { boost: 10 });
    }
  });
}

/** One section: its heading as a link, and its text around the first match, with all matches marked. */
function drawn({ heading, text, location }, { matchData }) {
  const places = Object.values(matchData.metadata).flatMap((found) => found.text?.position ?? []).sort(([one], [other]) => one - other);
  const from = places.length ? Math.max(0, text.lastIndexOf(" ", Math.max(0, places[0][0] - BEFORE)) + 1) : 0;
  const shown = document.createElement("p");
  let at = from;
  if (from > 0) shown.append("… ");
  for (const [start, length] of places.filter(([start, length]) => start + length <= from + SHOWN)) {
    if (start < at) continue;
    const mark = document.createElement("mark");
    mark.textContent = text.slice(start, start + length);
    shown.append(text.slice(at, start), mark);
    at = start + length;
  }
  shown.append(text.slice(at, from + SHOWN), text.length > from + SHOWN ? " …" : "");
  const [article, top, link] = ["article", "h3", "a"].map((name) => document.createElement(name));
  Object.assign(link, { href: `${base_url}/${location}`, textContent: heading });
  top.append(link);
  article.append(top, shown);
  return article;
}

async function start(input, list) {
  await Promise.all(["lunr.js", "index.js"].map(load));
  const [index, sections] = indexed();
  const answer = () => {
    const found = search(index, input.value);
    list.replaceChildren(...found.slice(0, 50).map((result) => drawn(sections.get(result.ref), result)));
    if (!found.length) list.textContent = input.value.trim() ? "No section has all of these words." : "";
  };
  input.value = new URLSearchParams(location.search).get("q") ?? "";
  input.addEventListener("input", answer);
  answer();
}

const input = document.getElementById("mkdocs-search-query");
if (input) start(input, document.getElementById("mkdocs-search-results"));
