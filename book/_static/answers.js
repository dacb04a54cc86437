// Check answers that are a few numbers. What they are judged by comes from rotedu.edition.exercises,
// and the verdict is that of Python's `check`.
const fits = (given, result, { within, period, eitherSign }) =>
  (eitherSign ? [1, -1] : [1]).some((sign) =>
    result.every((number, i) => {
      const off = given[i] - sign * number;
      // Any huge number would be a number of full turns, up to rounding.
      const turns = period ? Math.max(-1000, Math.min(1000, Math.round(off / period))) : 0;
      return Math.abs(off - turns * (period ?? 0)) <= within;
    }),
  );

// Return two stages of a hint, or nothing if the numbers are right.
const judge = (numbers, parts) => {
  for (const part of parts) {
    const given = part.items.map((i) => numbers[i]);
    if (fits(given, part.right, part)) continue;
    return part.mistakes.find(({ result }) => fits(given, result, part))?.hint ?? part.otherwise;
  }
};

// Read a number or a fraction, also with the minus sign of the page and a degree sign.
const read = (text, unit) => {
  const bare = unit.startsWith("°") ? text.replace(/°$/, "") : text;
  const [top, ...bottom] = bare.replaceAll("\u2212", "-").split("/");
  return [top, ...bottom].every((part) => part.trim()) && bottom.length < 2
    ? Number(top) / Number(bottom[0] ?? 1)
    : NaN;
};

const addForm = (place) => {
  const { number, fields, expects, because, parts } = JSON.parse(place.dataset.asked);
  const label = ([name, unit]) =>
    `<label>${name} <span><input autocomplete="off" maxlength="60"> ${unit}</span></label>`;
  place.innerHTML = `<form novalidate>
    <fieldset>
      <legend>Check your answer to ${number} here</legend>
      ${fields.map(label).join("")}
      <button name="check">Check</button>
    </fieldset>
    <output class="verdict"></output>
  </form>`;
  const form = place.firstChild;
  const inputs = [...form.querySelectorAll("input")];
  const output = form.querySelector("output");
  let hinted;

  const verdict = () => {
    const texts = inputs.map(({ value }) => value.trim());
    if (!texts.some(Boolean)) return [null, "Not answered yet."];
    if (!texts.every(Boolean)) return [null, "Fill in every field."];
    if (texts.some((text) => text.includes(","))) {
      return [null, "Write a point, not a comma: 0.5."];
    }
    const numbers = texts.map((text, i) => read(text, fields[i][1]));
    if (!numbers.every(Number.isFinite)) return [null, `Expected ${expects}.`];
    const hint = judge(numbers, parts);
    if (!hint) return [true, `Right. ${because}`.trim()];
    const [first, second] = hint;
    const again = hinted === first;
    hinted = first;
    return [
      false,
      again ? `Not yet. ${second}` : `Not yet. ${first} For a hint, press Check again.`,
    ];
  };

  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const [right, text] = verdict();
    if (right === null) delete output.dataset.right;
    else output.dataset.right = right;
    output.textContent = text;
    form.dispatchEvent(new CustomEvent("rotedu:verdict", { detail: { right, text } }));
  });
};

document.querySelectorAll(".answer-form").forEach(addForm);
