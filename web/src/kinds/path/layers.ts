// Several linkages at a place of the map.
import type {TauPair} from "../../contract/messages";

/** Which of the linkages at a place τ names: the first, the best there, where it names none. */
export function layer_at(layers: readonly {tau: TauPair}[], tau: TauPair): number {
  const has_axis = layers.some((layer) => Math.floor(layer.tau[1]) !== Math.floor(layers[0]!.tau[1])),
    k = has_axis ? 1 : 0; // an axis of their own, or the input's
  return Math.max(
    layers.findIndex((layer) => (has_axis || tau[0] >= 1) && Math.floor(layer.tau[k]) === Math.floor(tau[k])),
    0,
  );
}
