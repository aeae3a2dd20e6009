// How large the map is. It is a square; what stands above and below it keeps its height.

export interface MapSizes {
  map: number;
  strip: number; // left axis
  foot: number; // lower axis
  ridge: number;
}
const ridge = 18;
const chrome = {wide: 48 + 26 + 24 + 46 + 60, laptop: 48 + 26 + 24 + 46 + 60}; // bars, gaps, card head and legend
const phone_share = 0.4, // of the height: the rest is the drawing's and the legend's
  phone_rest = 430; // which needs so much: bars, heads, drive and a drawing that one can see
const numbers = {wide: 236, laptop: 196}; // what the numbers card needs below

export function map_sizes(
  kind: "wide" | "laptop" | "phone",
  card_width: number,
  screen_height: number,
  ridges: boolean,
  numbered: boolean,
  full: boolean,
): MapSizes {
  if (kind === "phone") {
    const strip = 22,
      foot = 18,
      on_its_side = screen_height < 500,
      bars = 48 + 46 + 44;
    return {
      map: Math.max(
        Math.floor(
          Math.min(
            card_width - strip - 16,
            (on_its_side ? screen_height - bars : Math.min(phone_share * screen_height, screen_height - phone_rest)) -
              foot -
              10,
          ),
        ),
        on_its_side ? 160 : 110,
      ),
      strip,
      foot,
      ridge: 0,
    };
  }
  const strip = numbered ? 42 : 34,
    foot = strip,
    extra = ridges ? ridge : 0;
  const across = card_width - strip - 24 - extra;
  const down = screen_height - chrome[kind] - foot - extra - (full ? 120 : numbers[kind]);
  const most = full ? 2000 : 560,
    least = kind === "wide" ? 300 : 240;
  return {
    map: Math.max(Math.floor(Math.min(across, Math.max(Math.min(down, most), least))), 0),
    strip,
    foot,
    ridge: extra,
  };
}
