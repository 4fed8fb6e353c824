// The search of the site, in place of MkDocs' own, which needs a server and knows no Greek letters: every word must be in a
// section; those with it in the title come first, then those with more of it. The index is a script, so that pages opened from a folder search too.
"use strict";
(function () {
    const list = document.getElementById("mkdocs-search-results");
    if (!list) return;
    const query = (new URLSearchParams(location.search).get("q") || "").trim();
    for (const box of document.querySelectorAll("input[name=q]")) box.value = query;
    const words = query.toLowerCase().split(/\s+/).filter(Boolean);

    function count(text, word) {
        let n = 0;
        for (let at = text.indexOf(word); at >= 0 && n < 20; at = text.indexOf(word, at + word.length)) ++n;
        return n;
    }
    function score(section) {
        const title = section.title.toLowerCase(), text = section.text.toLowerCase();
        let sum = 0;
        for (const word of words) {
            const inTitle = count(title, word), inText = count(text, word);
            if (!inTitle && !inText) return 0;
            sum += 10 * inTitle + (title === word ? 30 : 0) + inText / (1 + text.length / 2000);
        }
        return sum * (section.location.startsWith("files/") ? 0.1 : 1);
    }
    function element(name, text, parent) {
        const made = document.createElement(name);
        made.textContent = text;
        parent.append(made);
        return made;
    }
    function excerpt(section, place) {
        const low = section.text.toLowerCase(), first = Math.min(...words.map(w => low.indexOf(w)).filter(at => at >= 0));
        let from = Math.max(0, (Number.isFinite(first) ? first : 0) - 80);
        if (from) from = section.text.indexOf(" ", from) + 1; // words are not cut
        let rest = (from ? "... " : "") + section.text.slice(from, from + 260).replace(/\s+\S*$/, section.text.length > from + 260 ? " ..." : "$&");
        while (rest) {
            const lower = rest.toLowerCase();
            const [at, word] = words.map(w => [lower.indexOf(w), w]).filter(x => x[0] >= 0).sort((a, b) => a[0] - b[0])[0] || [-1, ""];
            if (at < 0) break;
            place.append(rest.slice(0, at));
            element("mark", rest.slice(at, at + word.length), place);
            rest = rest.slice(at + word.length);
        }
        place.append(rest);
    }
    list.textContent = "";
    if (!words.length) return;
    const found = search_index.map(section => [score(section), section]).filter(x => x[0] > 0).sort((a, b) => b[0] - a[0]);
    element("p", found.length ? `${found.length} sections` : "No section has all of these words.", list).id = "search-count";
    for (const [, section] of found.slice(0, 50)) {
        const entry = element("article", "", list);
        const link = element("a", section.title, element("h3", "", entry));
        link.href = section.location;
        if (section.page !== section.title) element("small", section.page, entry);
        excerpt(section, element("p", "", entry));
    }
})();
