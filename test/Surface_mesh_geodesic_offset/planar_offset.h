// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offset of segments and points in a rectangle of the plane, without a mesh: from all lines beside the segments and all
// circles around their ends, divided at their intersections.

#ifndef GEODESIC_OFFSET_TEST_PLANAR_OFFSET_H
#define GEODESIC_OFFSET_TEST_PLANAR_OFFSET_H

#include "planar_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test {

struct Rectangle
{
  double x0, y0, x1, y1;

  double diagonal() const { return std::hypot(x1 - x0, y1 - y0); }
  bool contains(const Point_2& p) const { return p.x() > x0 && p.x() < x1 && p.y() > y0 && p.y() < y1; }
};

/// Points of the rectangle at distance d from the legs. Each segment contributes two parallel segments, each end of a leg a
/// circle. All are divided at intersections with each other and the border; parts whose midpoint has distance d, by brute
/// force, remain, and are linked at common ends. The smaller distances are on the left. Throws if the offset touches
/// itself, which happens for isolated values of d. Loops without extent, just below the largest distance, are omitted.
class Planar_offset
{
public:
  struct Component
  {
    bool is_closed;
    double length;
  };

  Planar_offset(const std::vector<Leg>& legs, double d, const Rectangle& box)
    : legs_(legs), d_(d), box_(box), rounding_(8 * std::numeric_limits<double>::epsilon() * box.diagonal())
  {
    make_primitives();
    cut_at_border();
    for (std::size_t i = 0; i < primitives_.size(); ++i)
      for (std::size_t j = i + 1; j < primitives_.size(); ++j) cut(i, j);
    merge_nodes();
    keep_pieces();
    link();
  }

  const std::vector<Planar_piece>& pieces() const { return pieces_; }
  const std::vector<Component>& components() const { return components_; }

  std::size_t number_of_components(bool closed) const
  {
    std::size_t result = 0;
    for (const Component& c : components_) result += c.is_closed == closed ? 1 : 0;
    return result;
  }

  double length() const
  {
    double result = 0;
    for (const Component& c : components_) result += c.length;
    return result;
  }

  /// Speed of corners and ends on the border per unit of d.
  double speed_of_joints() const { return speed_; }

private:
  struct Cut
  {
    double position; // along a segment, or an angle
    std::size_t node;
  };
  struct Primitive
  {
    bool is_circle;
    Point_2 a, b; // ends of a segment; a: center of a circle
    std::vector<Cut> cuts;
  };
  struct Node
  {
    Point_2 point;
    bool is_on_border;
    Vector_2 border; // its direction
    std::size_t merged;
  };

  std::size_t add_node(const Point_2& p) { return add_node(p, false, Vector_2(0, 0)); }
  std::size_t add_node(const Point_2& p, bool on_border, const Vector_2& border)
  {
    nodes_.push_back({p, on_border, border, nodes_.size()});
    return nodes_.size() - 1;
  }

  void make_primitives()
  {
    std::map<Point_2, std::size_t> circles;
    std::set<std::pair<Point_2, Point_2>> segments;
    for (const Leg& leg : legs_)
    {
      for (const Point_2& p : {leg.a, leg.b})
        if (circles.emplace(p, primitives_.size()).second) primitives_.push_back({true, p, p, {}});
      if (leg.a != leg.b) segments.insert(std::minmax(leg.a, leg.b));
    }
    for (const auto& s : segments)
    {
      const Vector_2 along = s.second - s.first;
      const Vector_2 normal = (d_ / std::hypot(along.x(), along.y())) * quarter_turn(along);
      for (const bool left : {false, true})
      {
        const Point_2 from = left ? s.second : s.first, to = left ? s.first : s.second;
        const Vector_2 out = left ? normal : -normal;
        Primitive line{false, from + out, to + out, {}};
        for (const bool at_end : {false, true})
        {
          const std::size_t node = add_node(at_end ? line.b : line.a);
          line.cuts.push_back({at_end ? distance(line.a, line.b) : 0, node});
          cut_circle(primitives_[circles.at(at_end ? to : from)], node);
        }
        primitives_.push_back(line);
      }
    }
  }

  void cut_circle(Primitive& circle, std::size_t node)
  {
    const Vector_2 v = nodes_[node].point - circle.a;
    circle.cuts.push_back({std::atan2(v.y(), v.x()), node});
  }

  void cut_segment(Primitive& segment, std::size_t node)
  {
    segment.cuts.push_back({distance(segment.a, nodes_[node].point), node});
  }

  void cut(Primitive& primitive, std::size_t node)
  {
    if (primitive.is_circle) cut_circle(primitive, node);
    else cut_segment(primitive, node);
  }

  void cut(std::size_t i, std::size_t j)
  {
    Primitive &p = primitives_[i], &q = primitives_[j];
    std::vector<Point_2> points;
    if (p.is_circle && q.is_circle) points = circles_meet(p.a, q.a);
    else if (p.is_circle) points = line_meets_circle(q, p.a);
    else if (q.is_circle) points = line_meets_circle(p, q.a);
    else points = lines_meet(p, q);
    for (const Point_2& point : points)
    {
      const std::size_t node = add_node(point);
      cut(p, node);
      cut(q, node);
    }
  }

  void cut_at_border()
  {
    const Point_2 corners[] = {Point_2(box_.x0, box_.y0), Point_2(box_.x1, box_.y0), Point_2(box_.x1, box_.y1),
                               Point_2(box_.x0, box_.y1)};
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Primitive side{false, corners[k], corners[(k + 1) % 4], {}};
      const Vector_2 along = (side.b - side.a) / distance(side.a, side.b);
      for (Primitive& p : primitives_)
        for (const Point_2& point : p.is_circle ? line_meets_circle(side, p.a) : lines_meet(side, p))
          cut(p, add_node(point, true, along));
    }
  }

  std::vector<Point_2> circles_meet(const Point_2& a, const Point_2& b) const
  {
    const double half = distance(a, b) / 2;
    if (half >= d_) return {};
    const Point_2 middle = CGAL::midpoint(a, b);
    const Vector_2 up = (std::sqrt((d_ - half) * (d_ + half)) / (2 * half)) * quarter_turn(b - a);
    return {middle + up, middle - up};
  }

  std::vector<Point_2> line_meets_circle(const Primitive& line, const Point_2& center) const
  {
    const double length = distance(line.a, line.b);
    const Vector_2 along = (line.b - line.a) / length;
    const double foot = along * (center - line.a), height = std::abs(cross(along, center - line.a));
    if (height > d_ + rounding_) return {};
    std::vector<double> positions;
    if (height > d_ - rounding_) positions = {foot}; // tangent
    else
    {
      const double half = std::sqrt((d_ - height) * (d_ + height));
      positions = {foot - half, foot + half};
    }
    std::vector<Point_2> result;
    for (double x : positions)
      if (x > -rounding_ && x < length + rounding_) result.push_back(line.a + x * along);
    return result;
  }

  std::vector<Point_2> lines_meet(const Primitive& p, const Primitive& q) const
  {
    const double length = distance(p.a, p.b);
    const Vector_2 along = (p.b - p.a) / length;
    const double height_a = cross(along, q.a - p.a), height_b = cross(along, q.b - p.a);
    std::vector<Point_2> result;
    if (std::abs(height_a) <= rounding_ && std::abs(height_b) <= rounding_) // the same line
    {
      for (const Point_2& end : {p.a, p.b})
        if (segment_distance(end, q.a, q.b) <= rounding_) result.push_back(end);
      for (const Point_2& end : {q.a, q.b})
        if (segment_distance(end, p.a, p.b) <= rounding_) result.push_back(end);
      return result;
    }
    if ((height_a > rounding_ && height_b > rounding_) || (height_a < -rounding_ && height_b < -rounding_) ||
        height_a == height_b)
      return result;
    const double t = (std::min)(1., (std::max)(0., height_a / (height_a - height_b)));
    const Point_2 point = q.a + t * (q.b - q.a);
    const double x = along * (point - p.a);
    if (x > -rounding_ && x < length + rounding_) result.push_back(point);
    return result;
  }

  // Nodes where three or more primitives meet were found several times.
  void merge_nodes()
  {
    std::vector<std::size_t> order(nodes_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [this](std::size_t i, std::size_t j) { return nodes_[i].point < nodes_[j].point; });
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i; j-- > 0;)
      {
        Node &p = nodes_[order[i]], &q = nodes_[order[j]];
        if (p.point.x() - q.point.x() > rounding_) break;
        if (std::abs(p.point.y() - q.point.y()) > rounding_) continue;
        Node& first = nodes_[q.merged];
        if (p.is_on_border && !first.is_on_border)
        {
          first.is_on_border = true;
          first.border = p.border;
        }
        p.merged = q.merged;
        break;
      }
  }

  void keep_pieces()
  {
    for (Primitive& p : primitives_)
    {
      std::sort(p.cuts.begin(), p.cuts.end(), [](const Cut& a, const Cut& b) { return a.position < b.position; });
      const std::size_t n = p.cuts.size();
      if (n == 0) // a circle without intersections
      {
        const Point_2 point = p.a + Vector_2(d_, 0);
        keep(Planar_piece::arc(p.a, d_, 2 * CGAL_PI, point, point), none, none);
      }
      for (std::size_t i = 0; i + (p.is_circle ? 0 : 1) < n; ++i)
      {
        const Cut &first = p.cuts[i], &last = p.cuts[(i + 1) % n];
        const std::size_t a = nodes_[first.node].merged, b = nodes_[last.node].merged;
        const Point_2 start = nodes_[first.node].point, end = nodes_[last.node].point;
        double angle = last.position - first.position;
        if (p.is_circle && i + 1 == n) angle += 2 * CGAL_PI;
        if (a == b && (p.is_circle ? d_ * angle : distance(start, end)) <= 4 * rounding_) continue;
        keep(p.is_circle ? Planar_piece::arc(p.a, d_, angle, start, end) : Planar_piece::segment(start, end), a, b);
      }
    }
  }

  void keep(const Planar_piece& piece, std::size_t from, std::size_t to)
  {
    const Point_2 middle = piece.at(0.5);
    if (!box_.contains(middle)) return;
    for (const Leg& leg : legs_)
      if (segment_distance(middle, leg.a, leg.b) < d_ - rounding_) return;
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      if (ends_[i] == std::make_pair(from, to) && distance(pieces_[i].at(0.5), middle) <= 4 * rounding_)
        return; // overlapping lines
    pieces_.push_back(piece);
    ends_.push_back({from, to});
  }

  void link()
  {
    std::map<std::size_t, std::size_t> starting, ending;
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      if (ends_[i].first != none)
        if (!starting.emplace(ends_[i].first, i).second || !ending.emplace(ends_[i].second, i).second)
          throw std::logic_error("the planar offset touches itself");
    for (const auto& s : starting)
    {
      const auto e = ending.find(s.first);
      const bool on_border = nodes_[s.first].is_on_border;
      if ((e == ending.end()) != on_border) throw std::logic_error("the planar offset is not linked");
      add_speed(nodes_[s.first], gradient(s.second, nodes_[s.first].point),
                on_border ? Vector_2(0, 0) : gradient(e->second, nodes_[s.first].point));
    }
    for (const auto& e : ending)
      if (starting.find(e.first) == starting.end())
      {
        if (!nodes_[e.first].is_on_border) throw std::logic_error("the planar offset is not linked");
        add_speed(nodes_[e.first], gradient(e.second, nodes_[e.first].point), Vector_2(0, 0));
      }
    std::vector<bool> used(pieces_.size(), false);
    for (const bool closed : {false, true})
      for (std::size_t i = 0; i < pieces_.size(); ++i)
      {
        const bool is_first = ending.find(ends_[i].first) == ending.end() && ends_[i].first != none;
        if (used[i] || is_first == closed) continue;
        Component component{closed, 0};
        std::size_t j = i;
        std::vector<std::size_t> members;
        for (;;)
        {
          used[j] = true;
          members.push_back(j);
          component.length += pieces_[j].length();
          const auto next = starting.find(ends_[j].second);
          if (next == starting.end() || used[next->second]) break;
          j = next->second;
        }
        if (closed && component.length < 1e-10 * d_)
          for (std::size_t k : members) ends_[k] = {dropped, dropped};
        else components_.push_back(component);
      }
    std::vector<Planar_piece> rest;
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      if (ends_[i].first != dropped) rest.push_back(pieces_[i]);
    pieces_ = rest;
  }

  Vector_2 gradient(std::size_t piece, const Point_2& p) const
  {
    const Planar_piece& q = pieces_[piece];
    if (q.is_arc) return (p - q.center) / distance(p, q.center);
    return -quarter_turn(q.end - q.start) / q.length();
  }

  void add_speed(const Node& node, const Vector_2& g, const Vector_2& h)
  {
    const Vector_2 sum = (g + h) / 2;
    const double slope = node.is_on_border ? std::abs(g * node.border) : std::hypot(sum.x(), sum.y());
    speed_ = (std::max)(speed_, 1 / slope);
  }

  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  static constexpr std::size_t dropped = none - 1;

  std::vector<Leg> legs_;
  double d_;
  Rectangle box_;
  double rounding_;
  std::vector<Primitive> primitives_;
  std::vector<Node> nodes_;
  std::vector<Planar_piece> pieces_;
  std::vector<std::pair<std::size_t, std::size_t>> ends_;
  std::vector<Component> components_;
  double speed_ = 1;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_PLANAR_OFFSET_H
