// A pixel's list in order, whatever the order in which its fragments came: runs of 16 are sorted in registers by Batcher's
// odd-even merge sort (1968), the same comparisons for every pixel, then merged two by two in local memory; the last merge
// is not written but read by `takeNext`. Lists beyond HAVS_LOCAL_FRAGMENTS are sorted where they lie, by Shell's sort
// with the gaps of Knuth: n^1.5 at worst.
//
// Of equal distances exits leave first, then entries, then inner faces, each by the bits of their scalar. Between equal
// distances nothing is drawn and the inside-count behind them is their sum, so only the last matters, as the front of the
// next segment: an entry behind the exit that it touches, the far side of a cell too thin for float behind its near side.
// Fragments that this leaves open are the same bit for bit. So the picture does not depend on the order in which they came.
layout(rg32ui, binding = 0) uniform uimageBuffer fragments;

struct Entry {
  float distance;
  int key;  // the payload's bits, turned so that exits come first, inner faces last
};

const int kRun = 16;
const uint kKeyTurn = 0x40000000u;
const float kBeyondAll = 3.0e38;

Entry entryList[2 * HAVS_LOCAL_FRAGMENTS];  // two halves, merged from one into the other
Entry run[kRun];

bool isBefore(Entry a, Entry b) { return a.distance < b.distance || (a.distance == b.distance && a.key < b.key); }

Entry selectEntry(bool condition, Entry yes, Entry no) {
  return Entry(mix(no.distance, yes.distance, condition), mix(no.key, yes.key, condition));
}

Entry noEntry() { return Entry(kBeyondAll, 0); }

Entry loadEntry(int place) {
  uvec2 bits = imageLoad(fragments, place).xy;
  return Entry(uintBitsToFloat(bits.y), int(bits.x + kKeyTurn));
}

void storeEntry(int place, Entry entry) {
  imageStore(fragments, place, uvec4(uint(entry.key) - kKeyTurn, floatBitsToUint(entry.distance), 0u, 0u));
}

Fragment fragmentOf(Entry entry) {
  Fragment f;
  f.distance = entry.distance;
  f.payload = uintBitsToFloat(uint(entry.key) - kKeyTurn);
  return f;
}

void exchange(int low, int high) {
  Entry a = run[low], b = run[high];
  bool swapped = isBefore(b, a);
  run[low] = selectEntry(swapped, b, a);
  run[high] = selectEntry(swapped, a, b);
}

// The two stages of a merge of sorted runs of SIZE: first places SIZE apart, then STEP apart for halving steps. All places
// are known when compiled, and the loops are short enough for Mesa to unroll: the run stays in registers.
#define MERGE(SIZE) \
  for (int i = 0; i < 8; ++i) exchange(i / (SIZE) * 2 * (SIZE) + i % (SIZE), i / (SIZE) * 2 * (SIZE) + i % (SIZE) + (SIZE));
#define CLEAN(SIZE, STEP)                                                                    \
  for (int i = 0; i < 8 - 8 * (STEP) / (SIZE); ++i) {                                      \
    int inBlock = i % ((SIZE) - (STEP));                                                     \
    int low = i / ((SIZE) - (STEP)) * 2 * (SIZE) + (STEP) + inBlock / (STEP) * 2 * (STEP) + inBlock % (STEP); \
    exchange(low, low + (STEP));                                                             \
  }

void sortRun() {
  MERGE(1)
  MERGE(2)
  CLEAN(2, 1)
  MERGE(4)
  CLEAN(4, 2)
  CLEAN(4, 1)
  MERGE(8)
  CLEAN(8, 4)
  CLEAN(8, 2)
  CLEAN(8, 1)
}

void sortRuns(int first, int count) {
  for (int begin = 0; begin < count; begin += kRun) {
    for (int i = 0; i < kRun; ++i) {
      bool exists = begin + i < count;
      run[i] = selectEntry(exists, loadEntry(first + (exists ? begin + i : 0)), noEntry());
    }
    sortRun();
    for (int i = 0; i < kRun; ++i) entryList[begin + i] = run[i];
  }
}

void sortInPlace(int first, int count) {
  int gap = 1;
  while (gap < count / 3) gap = 3 * gap + 1;
  for (; gap > 0; gap = (gap - 1) / 3)
    for (int i = gap; i < count; ++i) {
      Entry moved = loadEntry(first + i);
      int j = i;
      for (; j >= gap; j -= gap) {
        Entry before = loadEntry(first + j - gap);
        if (!isBefore(moved, before)) break;
        storeEntry(first + j, before);
      }
      storeEntry(first + j, moved);
    }
}

// Two sorted stretches, read as one. In the picture's memory for a long list, whose second stretch is empty.
struct Merge {
  int a, endOfA, b, endOfB;  // places in entryList, or in the picture's memory
  Entry headOfA, headOfB;
  bool inPlace;
};

Entry entryAt(Merge m, int place, int end) {
  if (place >= end) return noEntry();
  if (m.inPlace) return loadEntry(place);
  return entryList[place];
}

Merge beginMerge(int begin, int middle, int end, bool inPlace) {
  Merge m = Merge(begin, middle, middle, end, noEntry(), noEntry(), inPlace);
  m.headOfA = entryAt(m, m.a, m.endOfA);
  m.headOfB = entryAt(m, m.b, m.endOfB);
  return m;
}

Entry takeNext(inout Merge m) {
  bool fromB = isBefore(m.headOfB, m.headOfA);
  Entry taken = selectEntry(fromB, m.headOfB, m.headOfA);
  m.a += fromB ? 0 : 1;
  m.b += fromB ? 1 : 0;
  Entry next = entryAt(m, fromB ? m.b : m.a, fromB ? m.endOfB : m.endOfA);
  m.headOfA = selectEntry(fromB, m.headOfA, next);
  m.headOfB = selectEntry(fromB, next, m.headOfB);
  return taken;
}

// Asked first: it ends at the first fragment out of place, and faces drawn near first mostly leave lists in order.
bool isSorted(int first, int count) {
  Entry last = loadEntry(first);
  int i = 1;
  for (; i < count; ++i) {
    Entry entry = loadEntry(first + i);
    if (isBefore(entry, last)) break;
    last = entry;
  }
  return i >= count;
}

// Sorts the list of `count` entries at `first`, up to a merge of two stretches, which is returned.
Merge sortList(int first, int count) {
  bool inPlace = isSorted(first, count);
  if (!inPlace && count > HAVS_LOCAL_FRAGMENTS) {
    sortInPlace(first, count);
    inPlace = true;
  }
  if (inPlace) return beginMerge(first, first + count, first + count, true);
  sortRuns(first, count);
  int from = 0, to = HAVS_LOCAL_FRAGMENTS, width = kRun;
  for (; 2 * width < count; width *= 2) {
    for (int begin = 0; begin < count; begin += 2 * width) {
      int end = min(begin + 2 * width, count);
      Merge m = beginMerge(from + begin, from + min(begin + width, count), from + end, false);
      for (int i = begin; i < end; ++i) entryList[to + i] = takeNext(m);
    }
    int other = from;
    from = to;
    to = other;
  }
  return beginMerge(from, from + min(width, count), from + count, false);
}
