#pragma once
// Variations of a document: the values of all its parameters under a name, kept in the graph file, and blends
// of them. Pure.
#include <string>
#include <vector>

#include "nodes/graph/graph.h"

namespace pileus::nodes {

struct Variation {
  std::string name;
  Graph values;  ///< the nodes with their type and parameters alone, groups with what they hold
};

/// Those of the document. Error (Input): what the file has under "variations" cannot be understood; it stays.
Result<std::vector<Variation>> variationsOf(const Graph& root);
Graph withVariations(const Graph& root, const std::vector<Variation>& variations);
/// "Variation 3", or the next number that is free.
std::string freeVariationName(const std::vector<Variation>& all);

/// The values of all parameters as they are, keys and what could not be read of them included.
Graph valuesOf(const Graph& root);
/// `root` with these values. Nodes that they do not know, or know as another type, keep theirs; links, places
/// and names stay.
Graph withValues(const Graph& root, const Graph& values);

/// Between values at 0 and others at 1, each of them exactly there. Numbers, vectors and colours by their
/// share, in the working space; whole numbers rounded; angles that may go around, the short way; everything
/// else (choices, texts, files, curves, keys) changes half way. Nodes of one of them alone are left out.
Graph blendedValues(const Graph& a, const Graph& b, double t);
/// Along a row of variations: 1.5 is half way from the second to the third. Clamped to the row.
Graph blendedValues(const std::vector<Variation>& row, double at);

}  // namespace pileus::nodes
