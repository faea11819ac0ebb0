/** Pieces of bytes, one after the other. */
export function joined(pieces) {
  const bytes = new Uint8Array(pieces.reduce((size, each) => size + each.length, 0));
  let place = 0;
  for (const piece of pieces) {
    bytes.set(piece, place);
    place += piece.length;
  }
  return bytes;
}
