/* The ways that parts of a figure have gone under the hand. */

// A longer step is a jump, and the way begins anew.
const JUMP = 1;
// A shorter one does not show.
const LEAST = 0.004;
// How many points a way keeps.
const MOST = 500;

/**
 * @returns {{follow: function, clear: function}} takes the places where parts are now, by name, and
 *   returns the parts of a state that draw their ways; hides the ways and forgets them
 */
export function trails() {
  const ways = new Map();
  const drawn = (pieces) => {
    const paths = pieces.filter((piece) => piece.length > 1);
    return paths.length ? { paths, hidden: false } : { hidden: true };
  };
  const follow = (places) => {
    for (const [name, place] of Object.entries(places)) {
      if (!ways.has(name)) ways.set(name, [[]]);
      const pieces = ways.get(name);
      const before = pieces.at(-1).at(-1);
      const step = before && place ? Math.hypot(...place.map((x, i) => x - before[i])) : 0;
      if (!place || step > JUMP) pieces.push([]);
      if (place && (!before || step > LEAST)) pieces.at(-1).push(place);
      if (pieces.flat().length > MOST && !pieces[0].shift()) pieces.shift();
    }
    return Object.fromEntries([...ways].map(([name, pieces]) => [name, drawn(pieces)]));
  };
  const clear = () => {
    const parts = Object.fromEntries([...ways.keys()].map((name) => [name, { hidden: true }]));
    ways.clear();
    return parts;
  };
  return { follow, clear };
}
