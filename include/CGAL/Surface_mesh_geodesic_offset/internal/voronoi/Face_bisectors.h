// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bisectors in one face: its windows, the changes of the nearest source on its edges, and the division into cells.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_FACE_BISECTORS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_FACE_BISECTORS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Face_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Geodesic_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Coinciding_places.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Initial_windows.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Cell_bisectors.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Face_cells.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Label_changes.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// The labels of cells: ids of sources, of which those that coincide up to rounding, or have a point or a segment in common, count as
// that with the smallest id there.
template <class FT>
class Source_labels
{
public:
  Source_labels(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field)
    : m_mesh(mesh), m_field(field)
  {
    const double tolerance = Voronoi_tolerances<double>::same_source(size());
    Coinciding_places<FT> places(mesh, tolerance);
    struct Entry
    {
      double start_value;
      bool varies;
      Index smallest; // id
    };
    std::map<std::pair<Index, Index>, std::vector<Entry>> entries; // by the numbers of the ends
    std::vector<std::pair<std::vector<Entry>*, std::size_t>> entry_of;
    for (std::size_t i = 0; i < initial.primitives.size(); ++i)
    {
      const Index first = places.number_of(initial.places[i].first),
                  second = initial.primitives[i].is_segment ? places.number_of(initial.places[i].second) : first;
      std::vector<Entry>& known = entries[std::minmax(first, second)];
      const double start = CGAL::to_double(initial.start_values.of(Source_ref(Index(i), Source_side::NONE)));
      // a segment along which start values vary is one with no other
      const bool varies = initial.primitives[i].varies;
      auto entry = std::find_if(known.begin(), known.end(), [&](const Entry& e) {
        return !varies && !e.varies && CGAL::abs(e.start_value - start) <= tolerance;
      });
      if (entry == known.end()) entry = known.insert(known.end(), {start, varies, initial.source_of[i]});
      entry->smallest = (std::min)(entry->smallest, initial.source_of[i]);
      entry_of.emplace_back(&known, std::size_t(entry - known.begin()));
    }
    for (const auto& [known, i] : entry_of) m_label.push_back((*known)[i].smallest);
  }

  // no_index for a vertex without a distance.
  Index of_vertex(Index v) const
  {
    return m_field.source_ref[v].is_valid() ? m_label[m_field.source_ref[v].primitive()] : no_index;
  }

  // A window behind a pseudo-source has the label of this vertex, also if several sources are equally near to it.
  template <class Window>
  Index of_window(const Window& w) const
  {
    const Index v = w.pseudo_source();
    return v == no_index || Merge_error_code::is_merged(v) ? m_label[w.source_ref.primitive()] : of_vertex(v);
  }

private:
  // The longest edge and the largest distance of a vertex.
  double size() const
  {
    double largest = 0;
    for (const FT& d : m_field.distance)
      if (Number_policy<FT>::is_finite(d)) largest = (std::max)(largest, CGAL::to_double(d));
    return CGAL::to_double(m_mesh.longest_edge()) + largest;
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Geodesic_field<FT>& m_field;
  std::vector<Index> m_label; // per primitive
};

template <class NT, class FT>
class Face_bisectors
{
public:
  typedef Point_in_face<NT> Point;

  Face_bisectors(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field)
    : m_mesh(mesh), m_initial(initial), m_results(field), m_labels(mesh, initial, field), m_field(mesh, initial, field)
  {
  }

  // Reads the windows of a face. Returns false if it has one label, also at its corners; then there are no windows, but gates of
  // neighbours may be connected.
  bool set_face(Index face)
  {
    m_field.set_frame(face);
    m_windows.clear();
    m_all.clear();
    m_tolerances = Voronoi_tolerances<NT>(number_cast<NT>(m_field.size()));
    m_cell.gates.clear();
    for (int k = 0; k < 3; ++k)
    {
      m_cell.corner[k] = rounded(m_field.frame().corner(k));
      m_cell.direction[k] = rounded(m_field.frame().direction(k));
      m_cell.label[k] = m_labels.of_vertex(m_mesh.source(3 * face + Index(k)));
    }
    if (has_one_label()) return false;

    m_field.set_face(face);
    for (const auto& w : m_field.windows()) add(w);
    meet_neighbours();
    for (const auto& w : m_field.windows())
      if (w.origin == STARTS_AT_CORNER && w.sigma == m_results.distance[m_mesh.source(3 * face + Index(w.edge))])
        add(whole_corner(w));
    NT magnitude = 0; // of the windows that may be nearest
    remove_farther(m_cell, m_all);
    remove_outside(m_cell, m_all, m_tolerances.joint);
    for (const unsigned i : m_all) magnitude = (std::max)(magnitude, m_windows[i].largest_at_chord());
    m_tolerances = Voronoi_tolerances<NT>(magnitude + number_cast<NT>(m_field.size()));
    return !has_one_label_at(m_cell, m_all);
  }

  // Label of the first corner: of the whole face, if there are no arcs in it.
  Index label() const { return m_cell.label[0]; }

  // The nearest sources of points of the face.
  Face_cells<NT> cells() const
  {
    std::vector<Voronoi_window<NT>> windows;
    for (const unsigned i : m_all) windows.push_back(m_windows[i]);
    return Face_cells<NT>(m_cell.corner, m_tolerances.usual_tie, std::move(windows));
  }

  // Calls out(change) for the changes of the label along halfedge k.
  template <class OutputFunction>
  void find_changes(int k, const OutputFunction& out)
  {
    m_changes(m_cell.corner[k], m_cell.direction[k], number_cast<NT>(m_field.frame().edge_length(k)), m_cell.label[k],
              m_cell.label[(k + 1) % 3], m_windows, m_all, m_all, m_tolerances, std::nullopt, out);
  }

  // Adds a gate at a distance from the start of halfedge k. Gates come in order.
  void add_gate(int k, NT t, Index from, Index to, Index node)
  {
    m_cell.gates.push_back({m_cell.corner[k] + t * m_cell.direction[k], (unsigned char)(k), from, to, node});
  }

  // Calls out(arc) for the arcs in the face. Nodes that are not gates have the numbers new_node().
  template <class New_node, class OutputFunction>
  void find_arcs(const New_node& new_node, const OutputFunction& out)
  {
    CGAL_precondition(m_cell.is_consistent());
    const auto write = [&](Bisector_arc<NT> arc) {
      complete(arc);
      out(arc);
    };
    Cell_bisectors<NT> bisectors(m_windows, m_tolerances, m_cell);
    Gate_links<NT> links(m_windows, m_tolerances, m_cell);
    std::size_t divisions = 0, divisions_for_windows = 0;
    m_pending.clear();
    add_pending({m_cell, m_all, m_all.size() + 1, 0, 0});
    while (!m_pending.empty())
    {
      std::pop_heap(m_pending.begin(), m_pending.end(), is_smaller);
      Part part = std::move(m_pending.back());
      m_pending.pop_back();
      remove_farther(part.cell, part.near);
      // windows along a side only are those of the neighbour
      std::vector<unsigned> inside = part.near;
      remove_outside(part.cell, inside, -m_tolerances.along_side());
      if (part.cell.gates.empty() && has_one_label_at(part.cell, inside)) continue;
      const bool is_divisible = part.diameter > m_tolerances.smallest_cell;
      part.divisions_in_vain = inside.size() < part.windows_before ? 0 : part.divisions_in_vain + 1;
      part.windows_before = inside.size();
      const bool has_many_windows =
        inside.size() > Voronoi_tolerances<NT>::most_windows && is_divisible &&
        part.divisions_in_vain < Voronoi_tolerances<NT>::most_divisions_in_vain &&
        divisions_for_windows < Voronoi_tolerances<NT>::most_divisions_for_windows * m_all.size();
      m_arcs.clear();
      const auto add = [&](const Bisector_arc<NT>& a) { m_arcs.push_back(a); };
      if (has_many_windows)
      {
        if (inside.size() <= Voronoi_tolerances<NT>::most_windows_at_once &&
            bisectors.connect_at_once(part.cell, inside, new_node, add))
        {
          std::for_each(m_arcs.begin(), m_arcs.end(), write);
          continue;
        }
        ++divisions_for_windows;
      }
      else
      {
        const bool may_divide = is_divisible && divisions < Voronoi_tolerances<NT>::most_divisions * m_all.size();
        if (connect(part, inside, is_divisible, may_divide, bisectors, links, new_node, write)) continue;
        ++divisions;
      }
      auto halves = part.cell.divided(
        [&](const Point& o, const Point& u, NT size, Index first, Index last, const auto& add) {
          m_changes(o, u, size, first, last, m_windows, inside, part.near, m_tolerances, m_cell.center(), add);
        },
        new_node);
      Part second = part;
      part.cell = std::move(halves.first);
      second.cell = std::move(halves.second);
      add_pending(std::move(part));
      add_pending(std::move(second));
    }
    m_number_of_divisions += divisions;
  }

  const Voronoi_tolerances<NT>& tolerances() const { return m_tolerances; }
  std::size_t number_of_divisions() const { return m_number_of_divisions; }       // of cells that did not fit together
  std::size_t number_of_forced_cells() const { return m_number_of_forced_cells; } // larger than rounding

private:
  static constexpr unsigned no_window = ~0u;

  struct Part
  {
    Voronoi_cell<NT> cell;
    std::vector<unsigned> near; // windows that may be nearest
    std::size_t windows_before; // the last division
    int divisions_in_vain;      // in a row, which left all windows
    NT diameter;
  };
  static bool is_smaller(const Part& a, const Part& b) { return a.diameter < b.diameter; }

  // The largest cells are divided first, so that those left when the divisions are used up are small.
  void add_pending(Part part)
  {
    part.diameter = part.cell.diameter();
    m_pending.push_back(std::move(part));
    std::push_heap(m_pending.begin(), m_pending.end(), is_smaller);
  }

  // True if all windows and all corners of the face have one label. A window behind a corner has the label of the corner.
  bool has_one_label() const
  {
    bool result = m_cell.label[1] == m_cell.label[0] && m_cell.label[2] == m_cell.label[0];
    const auto check = [&](const auto& w) { result = result && m_labels.of_window(w) == m_cell.label[0]; };
    const auto local = local_windows(m_initial, m_field.face());
    std::for_each(local.first, local.second, [&](const auto& l) { check(l.window); });
    for (Index h = 3 * m_field.face(); result && h < 3 * m_field.face() + 3; ++h) m_results.for_each_window(m_mesh, h, check);
    return result;
  }

  // Finds and writes the arcs of a part. Returns false if they do not fit together and the part may be divided.
  template <class New_node, class Write>
  bool connect(const Part& part, const std::vector<unsigned>& inside, bool is_divisible, bool may_divide,
               Cell_bisectors<NT>& bisectors, Gate_links<NT>& links, const New_node& new_node, const Write& write)
  {
    const bool fits = bisectors.connect(part.cell, inside, new_node, [&](const Bisector_arc<NT>& a) { m_arcs.push_back(a); });
    const auto holds_along = [&](const Bisector_arc<NT>& a) {
      return links.is_verified(a, part.near, bisectors.has_wide_joints());
    };
    const bool holds = fits && (!bisectors.has_loose_joints() || std::all_of(m_arcs.begin(), m_arcs.end(), holds_along));
    if (!holds)
    {
      std::vector<Bisector_arc<NT>> found;
      if (may_divide) bisectors.find_arcs(part.cell, inside, found);
      if (links.connect(part.cell, part.near, found, new_node, write)) return true;
      if (may_divide) return false;
    }
    if (!fits) links.connect_straight(part.cell, new_node, write);
    else std::for_each(m_arcs.begin(), m_arcs.end(), write);
    if (!holds && is_divisible) ++m_number_of_forced_cells;
    return true;
  }

  // Sets the face of an arc, the edges of its ends at gates, and the edge along which it runs.
  void complete(Bisector_arc<NT>& arc) const
  {
    arc.face = m_field.face();
    arc.negligible = m_tolerances.negligible;
    arc.smallest_loop = m_tolerances.smallest_loop;
    for (const Voronoi_gate<NT>& g : m_cell.gates)
    {
      if (g.node == arc.start_node) arc.start_edge = g.side;
      if (g.node == arc.end_node) arc.end_edge = g.side;
    }
    for (int k = 0; k < 3; ++k)
    {
      if (!arc.is_on(m_cell.outside(k), arc.negligible)) continue;
      const Index h = 3 * arc.face + Index(k);
      arc.edge = (std::min)(h, m_mesh.twin(h));
      arc.along_edge = (arc.edge == h ? 1 : -1) * dot(arc.end - arc.start, m_cell.direction[k]);
    }
  }

  static Point rounded(const Point_in_face<FT>& p) { return {number_cast<NT>(p.x), number_cast<NT>(p.y)}; }

  void add(const Face_window<FT>& w)
  {
    if (w.is_empty()) return;
    Voronoi_window<NT> v(w, m_labels.of_window(w));
    v.rays.start_value = number_cast<NT>(m_results.start_values.of(w.source_ref)); // windows over edges come without
    if (!is_finite(v.bound[0].m) || !is_finite(v.bound[1].m)) return;
    m_all.push_back(unsigned(m_windows.size()));
    m_windows.push_back(v);
  }

  // The function d(v) + |p - v| of a corner in the whole face. It is an upper bound everywhere, and tells the distance where
  // rounding leaves points outside all cones, as beside an edge that is in line with a source; so it counts only where it is
  // nearer by more than a loose tie.
  Face_window<FT> whole_corner(Face_window<FT> w) const
  {
    w.right = m_field.frame().corner((w.edge + 1) % 3);
    w.left = m_field.frame().corner((w.edge + 2) % 3);
    w.sigma = w.sigma + FT(Voronoi_tolerances<NT>(number_cast<NT>(m_field.size() + w.sigma)).loose_tie);
    return w;
  }

  // For windows whose bounding rays start at one point: ends their cones at a common ray, if there is one, and sets how far beyond
  // their rays the distances tie.
  void meet_neighbours()
  {
    typedef std::pair<NT, unsigned> Place; // x coordinate, window
    std::vector<Place> left;
    std::vector<std::array<unsigned, 2>> meetings;                                           // of a right and a left ray
    std::vector<std::array<unsigned, 2>> neighbor(m_windows.size(), {no_window, no_window}); // on the left, on the right
    for (unsigned i = 0; i < m_windows.size(); ++i) left.emplace_back(m_windows[i].start_of_bound(0).x, i);
    std::sort(left.begin(), left.end());
    for (unsigned i = 0; i < m_windows.size(); ++i)
    {
      const Point p = m_windows[i].start_of_bound(1);
      for (auto next = std::lower_bound(left.begin(), left.end(), Place(p.x - m_tolerances.joint, 0));
           next != left.end() && next->first <= p.x + m_tolerances.joint; ++next)
      {
        const NT gap = length(m_windows[next->second].start_of_bound(0) - p);
        if (next->second == i || gap > m_tolerances.joint) continue;
        meetings.push_back({i, next->second});
        if (!meet_at_common_ray(i, next->second) &&
            !(gap <= m_tolerances.tie && m_windows[i].continues_in(m_windows[next->second])))
          continue;
        neighbor[i][1] = next->second;
        neighbor[next->second][0] = i;
      }
    }
    for (const auto& [i, next] : meetings)
    {
      set_tied(i, 1, next);
      set_tied(next, 0, i);
    }
    remove_rays(neighbor);
  }

  // Sets how far beyond its left (0) or right (1) ray the distances of a window tie with those of another source that starts there.
  void set_tied(unsigned i, int k, unsigned next)
  {
    if (m_windows[i].label != m_windows[next].label) m_windows[i].set_tied(k, m_windows[next], tie_of_rays(i, next));
  }

  // Beside a common ray, windows of both sources may alternate. Removes those that are only this ray; their neighbours meet at it.
  // Binding test: test_voronoi_diagram, lost strip, voxels.
  void remove_rays(const std::vector<std::array<unsigned, 2>>& neighbor)
  {
    const NT size = number_cast<NT>(m_field.size());
    const auto is_ray = [&](unsigned i) {
      return i != no_window && neighbor[i][0] != no_window && neighbor[i][1] != no_window &&
             this->m_windows[i].is_one_ray(size, this->m_tolerances.tie);
    };
    std::vector<unsigned> kept;
    std::copy_if(m_all.begin(), m_all.end(), std::back_inserter(kept), [&](unsigned i) { return !is_ray(i); });
    for (const unsigned i : kept)
      for (int k = 0; k < 2; ++k)
      {
        const unsigned first = neighbor[i][std::size_t(k)];
        unsigned next = first;
        for (std::size_t n = 0; is_ray(next) && n < neighbor.size(); ++n) next = neighbor[next][std::size_t(k)];
        if (next == no_window || next == i) continue;
        const NT tie = (std::max)(tie_of_rays(i, next), tie_of_rays(first, next));
        if (next != first) m_windows[i].extend_to(m_windows[first], k, along_chord(m_windows[i]), size, tie);
        if (m_windows[next].label != m_windows[i].label) m_windows[i].set_tied(k, m_windows[next], tie);
      }
    m_all.swap(kept);
  }

  NT tie_of_rays(unsigned i, unsigned j) const
  {
    const NT distance = (std::max)(m_windows[i].largest_at_chord(), m_windows[j].largest_at_chord());
    return Voronoi_tolerances<NT>(distance + number_cast<NT>(m_field.size())).tie_of_rays;
  }

  // Ends the cones of two windows at their common ray, if there is one; and those of other windows with the same functions that end
  // there up to rounding.
  bool meet_at_common_ray(unsigned left, unsigned right)
  {
    const NT tie = tie_of_rays(left, right);
    const auto ray = m_windows[left].common_ray(m_windows[right], tie);
    if (!ray) return false;
    // A chord that ends at a corner is not longer than it seems, nor is the start of rays beside a source.
    const auto may_end = [&](const Voronoi_window<NT>& w, int k) {
      const Point p = w.start_of_bound(k);
      const NT beyond = (k == 0 ? 1 : -1) * ray->left.value(p);
      return w.is_bound(*ray, k, tie) && (beyond <= tie || (beyond <= w.extension(k, tie) && !this->is_corner(p)));
    };
    if (!may_end(m_windows[left], 1) || !may_end(m_windows[right], 0)) return false;
    const Voronoi_window<NT> on_left(m_windows[left]), on_right(m_windows[right]);
    const Point center = m_cell.center();
    const NT radius = m_cell.radius();
    for (Voronoi_window<NT>& w : m_windows)
    {
      if (w.label == on_left.label && w.is_same_function(on_left, center, radius, tie) && may_end(w, 1))
        w.end_at(*ray, 1, along_chord(w));
      if (w.label == on_right.label && w.is_same_function(on_right, center, radius, tie) && may_end(w, 0))
        w.end_at(*ray, 0, along_chord(w));
    }
    return true;
  }

  // Unit vector along the edge over which a window comes, or along its chord.
  Point along_chord(const Voronoi_window<NT>& w) const
  {
    if (w.rays.origin < STARTS_IN_FACE) return m_cell.direction[std::size_t(w.rays.origin)];
    const Point chord = w.rays.right - w.rays.left;
    const NT size = length(chord);
    return size > 0 ? (1 / size) * chord : Point{0, 0};
  }

  bool is_corner(const Point& p) const
  {
    return std::any_of(m_cell.corner.begin(), m_cell.corner.end(),
                       [&](const Point& c) { return length(p - c) <= m_tolerances.joint; });
  }

  // Removes the windows that are nowhere nearest in a cell. Distances are 1-Lipschitz.
  void remove_farther(const Voronoi_cell<NT>& cell, std::vector<unsigned>& windows) const
  {
    const Point center = cell.center();
    const NT radius = cell.radius();
    const NT upper = least_path_length(m_windows, windows, center) + radius + m_tolerances.slack;
    const auto is_farther = [&](unsigned i) { return m_windows[i].lower_bound(center, radius) > upper; };
    windows.erase(std::remove_if(windows.begin(), windows.end(), is_farther), windows.end());
  }

  // Removes the windows whose cones are farther than `outside` from a cell.
  void remove_outside(const Voronoi_cell<NT>& cell, std::vector<unsigned>& windows, NT outside) const
  {
    const auto is_elsewhere = [&](unsigned i) {
      const Voronoi_window<NT>& w = m_windows[i];
      for (int k = 0; k < w.number_of_bounds; ++k)
      {
        const Half_plane<NT>& h = w.bound[std::size_t(k)];
        if ((std::min)({h.value(cell.corner[0]), h.value(cell.corner[1]), h.value(cell.corner[2])}) > outside) return true;
      }
      return false;
    };
    windows.erase(std::remove_if(windows.begin(), windows.end(), is_elsewhere), windows.end());
  }

  // True if all windows and all corners have one label.
  bool has_one_label_at(const Voronoi_cell<NT>& cell, const std::vector<unsigned>& windows) const
  {
    const Index label = cell.label[0];
    return cell.label[1] == label && cell.label[2] == label &&
           std::all_of(windows.begin(), windows.end(), [&](unsigned i) { return m_windows[i].label == label; });
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Initial_windows<FT>& m_initial;
  const Geodesic_field<FT>& m_results;
  const Source_labels<FT> m_labels;
  Face_field<FT> m_field;
  Voronoi_cell<NT> m_cell; // the face
  Voronoi_tolerances<NT> m_tolerances;
  std::vector<Voronoi_window<NT>> m_windows;
  std::vector<unsigned> m_all;          // windows that may be nearest
  std::vector<Bisector_arc<NT>> m_arcs; // of a cell
  std::vector<Part> m_pending;          // a heap
  Label_changes<NT> m_changes;
  std::size_t m_number_of_divisions = 0, m_number_of_forced_cells = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
