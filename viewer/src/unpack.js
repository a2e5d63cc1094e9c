// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads what page/Packed_stream.h writes: base64, deflated, in sections.

function bytesOfBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function inflated(bytes, size) {
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate")).getReader();
  const out = new Uint8Array(size);
  for (let at = 0; ; ) {
    const { done, value } = await reader.read();
    if (done) return out;
    out.set(value, at);
    at += value.length;
  }
}

/** The sections of a part of the page: a Reader for each name. Its text is let go. */
export async function readPart(element, header) {
  const bytes = await inflated(bytesOfBase64(element.textContent.trim()), header.bytes);
  element.textContent = "";
  const sections = {};
  for (const [name, begin] of header.sections) sections[name] = new Reader(bytes, begin);
  return sections;
}

class Reader {
  constructor(bytes, at) {
    this.bytes = bytes;
    this.at = at;
  }

  byte() {
    return this.bytes[this.at++];
  }

  number() {
    let n = 0;
    for (let factor = 1; ; factor *= 128) {
      const b = this.bytes[this.at++];
      n += (b & 127) * factor;
      if (b < 128) return n;
    }
  }

  signed() {
    return unfolded(this.number());
  }

  /** n numbers, from their differences, into an array of the given type. */
  differences(n, Type) {
    const values = new Type(n);
    let last = 0;
    for (let i = 0; i < n; ++i) values[i] = last += this.signed();
    return values;
  }

  /** n numbers, from planes of their bytes. */
  planes(n, bytes) {
    const values = new Uint32Array(n);
    for (let k = 0; k < bytes; ++k)
      for (let i = 0; i < n; ++i) values[i] |= this.bytes[this.at++] << (8 * k);
    return values;
  }
}

function unfolded(n) {
  return n % 2 === 0 ? n / 2 : -(n - 1) / 2 - 1;
}

/** Three coordinates of each of n points, in steps, from their differences; appended behind `first` points. */
export function readPoints(reader, n, into, first) {
  for (let k = 0; k < 3; ++k) {
    const folded = reader.planes(n, 4);
    let last = 0;
    for (let i = 0; i < n; ++i) {
      last += unfolded(folded[i]);
      into[3 * (first + i) + k] = last;
    }
  }
}

/** Qualities from -1 to 1. */
export function readQuality(reader, n) {
  const packed = reader.planes(n, 2);
  const quality = new Float32Array(n);
  for (let i = 0; i < n; ++i) quality[i] = (packed[i] / 4095) * 2 - 1;
  return quality;
}
