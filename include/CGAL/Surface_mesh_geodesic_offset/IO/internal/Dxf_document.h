// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// DXF document of AutoCAD 2000 (AC1015): polylines on layers, and the tables and objects that AutoCAD requires.
// Not CGAL's Dxf_writer: its polylines are in the xy plane and have no arcs, and its files have no unit of length.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_DXF_DOCUMENT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_DXF_DOCUMENT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/Length_unit.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/discretized_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/plane_pieces.h>

#include <algorithm>
#include <cstddef>
#include <ios>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::IO::Surface_mesh_geodesic_offset_internal {

struct Dxf_vertex
{
  Coordinates point;
  // Bulge of the edge to the next vertex: tangent of a quarter of the angle, positive if counterclockwise.
  double bulge = 0;
};

struct Dxf_polyline
{
  std::size_t layer = 0;
  bool is_flat = false;   // all points are in the plane with these axes, and may have bulges
  bool is_closed = false; // the first point is not repeated
  Plane_axes axes;
  double elevation = 0; // coordinate of the plane along its normal
  std::vector<Dxf_vertex> vertices;
};

// Every object of a document has a hexadecimal number, its handle.
class Dxf_document
{
public:
  explicit Dxf_document(std::ostream& os) : m_os(os) {}

  void write(const std::vector<std::string>& layers, const std::vector<Dxf_polyline>& polylines, const Bbox_3& box,
             Length_unit unit)
  {
    header(layers.size(), polylines, box, unit);
    m_os << "0\nSECTION\n2\nCLASSES\n0\nENDSEC\n";
    tables(layers, box);
    m_os << "0\nSECTION\n2\nBLOCKS\n";
    block("*Model_Space", model_space, 0x20);
    block("*Paper_Space", paper_space, 0x22);
    m_os << "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
    m_next = first_entity(layers.size());
    for (const Dxf_polyline& p : polylines)
      if (p.is_flat) flat_polyline(p, layers[p.layer]);
      else spatial_polyline(p, layers[p.layer]);
    m_os << "0\nENDSEC\n";
    objects();
    m_os << "0\nEOF\n";
  }

private:
  // handles
  static constexpr std::size_t dictionary = 0xC, groups = 0xD, plot_styles = 0xE, plot_style = 0xF, layer_table = 0x2,
                               model_space = 0x1F, paper_space = 0x1B, first_layer = 0x100;

  static std::size_t first_entity(std::size_t number_of_layers) { return first_layer + number_of_layers; }

  // Value of $INSUNITS.
  static int number_of(Length_unit unit)
  {
    switch (unit)
    {
    case Length_unit::INCH: return 1;
    case Length_unit::MILLIMETER: return 4;
    case Length_unit::CENTIMETER: return 5;
    case Length_unit::METER: return 6;
    default: return 0;
    }
  }

  static std::string hexadecimal(std::size_t n)
  {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::hex << std::uppercase << n;
    return text.str();
  }

  template <class Value>
  void group(int code, const Value& value)
  {
    m_os << code << '\n' << value << '\n';
  }

  void point(int code, const Coordinates& p)
  {
    for (int i = 0; i < 3; ++i) group(code + 10 * i, p[std::size_t(i)]);
  }

  // Writes type, handle, owner and class of an object.
  void object(const char* type, std::size_t handle, std::size_t owner, const char* class_name)
  {
    group(0, type);
    group(5, hexadecimal(handle));
    group(330, hexadecimal(owner));
    group(100, class_name);
  }

  void header(std::size_t number_of_layers, const std::vector<Dxf_polyline>& polylines, const Bbox_3& box, Length_unit unit)
  {
    std::size_t next = first_entity(number_of_layers);
    for (const Dxf_polyline& p : polylines) next += p.is_flat ? 1 : p.vertices.size() + 2;
    m_os << "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n9\n$DWGCODEPAGE\n3\nANSI_1252\n9\n$INSUNITS\n";
    group(70, number_of(unit));
    group(9, "$HANDSEED");
    group(5, hexadecimal(next));
    group(9, "$EXTMIN");
    point(10, {box.xmin(), box.ymin(), box.zmin()});
    group(9, "$EXTMAX");
    point(10, {box.xmax(), box.ymax(), box.zmax()});
    m_os << "0\nENDSEC\n";
  }

  void table(const char* name, std::size_t handle, std::size_t entries)
  {
    group(0, "TABLE");
    group(2, name);
    group(5, hexadecimal(handle));
    group(330, 0);
    group(100, "AcDbSymbolTable");
    group(70, entries);
  }

  void entry(const char* type, std::size_t handle, std::size_t table, const char* class_name, const std::string& name)
  {
    object(type, handle, table, "AcDbSymbolTableRecord");
    group(100, class_name);
    group(2, name);
  }

  void end_table() { m_os << "0\nENDTAB\n"; }

  void tables(const std::vector<std::string>& layers, const Bbox_3& box)
  {
    m_os << "0\nSECTION\n2\nTABLES\n";
    table("VPORT", 0x8, 1);
    viewport(box);
    end_table();
    table("LTYPE", 0x5, 3);
    line_type("ByBlock", 0x14, "");
    line_type("ByLayer", 0x15, "");
    line_type("Continuous", 0x16, "Solid line");
    end_table();
    table("LAYER", layer_table, layers.size() + 1);
    layer("0", 0x10);
    for (std::size_t i = 0; i < layers.size(); ++i) layer(layers[i], first_layer + i);
    end_table();
    table("STYLE", 0x3, 1);
    entry("STYLE", 0x11, 0x3, "AcDbTextStyleTableRecord", "Standard");
    m_os << "70\n0\n40\n0\n41\n1\n50\n0\n71\n0\n42\n1\n3\ntxt\n4\n\n";
    end_table();
    table("VIEW", 0x6, 0);
    end_table();
    table("UCS", 0x7, 0);
    end_table();
    table("APPID", 0x9, 1);
    entry("APPID", 0x12, 0x9, "AcDbRegAppTableRecord", "ACAD");
    m_os << "70\n0\n";
    end_table();
    table("DIMSTYLE", 0xA, 1);
    m_os << "100\nAcDbDimStyleTable\n71\n0\n0\nDIMSTYLE\n105\n27\n330\nA\n100\nAcDbSymbolTableRecord\n"
            "100\nAcDbDimStyleTableRecord\n2\nStandard\n70\n0\n";
    end_table();
    table("BLOCK_RECORD", 0x1, 2);
    entry("BLOCK_RECORD", model_space, 0x1, "AcDbBlockTableRecord", "*Model_Space");
    group(340, 0);
    entry("BLOCK_RECORD", paper_space, 0x1, "AcDbBlockTableRecord", "*Paper_Space");
    group(340, 0);
    end_table();
    m_os << "0\nENDSEC\n";
  }

  // Initial view: everything from above.
  void viewport(const Bbox_3& box)
  {
    const double width = box.x_span(), height = box.y_span();
    const double size = 1.1 * (std::max)(width, height);
    entry("VPORT", 0x29, 0x8, "AcDbViewportTableRecord", "*Active");
    m_os << "70\n0\n10\n0\n20\n0\n11\n1\n21\n1\n";
    group(12, box.xmin() + width / 2);
    group(22, box.ymin() + height / 2);
    m_os << "13\n0\n23\n0\n14\n10\n24\n10\n15\n10\n25\n10\n16\n0\n26\n0\n36\n1\n17\n0\n27\n0\n37\n0\n";
    group(40, size > 0 ? size : 1);
    m_os << "41\n1.5\n42\n50\n43\n0\n44\n0\n50\n0\n51\n0\n71\n0\n72\n100\n73\n1\n74\n3\n75\n0\n76\n0\n77\n0\n78\n0\n";
  }

  void line_type(const char* name, std::size_t handle, const char* description)
  {
    entry("LTYPE", handle, 0x5, "AcDbLinetypeTableRecord", name);
    group(70, 0);
    group(3, description);
    m_os << "72\n65\n73\n0\n40\n0\n";
  }

  void layer(const std::string& name, std::size_t handle)
  {
    entry("LAYER", handle, layer_table, "AcDbLayerTableRecord", name);
    m_os << "70\n0\n62\n7\n6\nContinuous\n370\n-3\n";
    group(390, hexadecimal(plot_style));
  }

  void block(const char* name, std::size_t record, std::size_t handle)
  {
    object("BLOCK", handle, record, "AcDbEntity");
    m_os << "8\n0\n100\nAcDbBlockBegin\n2\n" << name << "\n70\n0\n10\n0\n20\n0\n30\n0\n3\n" << name << "\n1\n\n";
    object("ENDBLK", handle + 1, record, "AcDbEntity");
    m_os << "8\n0\n100\nAcDbBlockEnd\n";
  }

  void flat_polyline(const Dxf_polyline& p, const std::string& layer)
  {
    object("LWPOLYLINE", m_next++, model_space, "AcDbEntity");
    group(8, layer);
    group(100, "AcDbPolyline");
    group(90, p.vertices.size());
    group(70, p.is_closed ? 1 : 0);
    group(43, 0);
    group(38, p.elevation);
    for (const Dxf_vertex& v : p.vertices)
    {
      const Plane_point q = p.axes(Space_vector(v.point[0], v.point[1], v.point[2]));
      group(10, q[0]);
      group(20, q[1]);
      if (v.bulge != 0) group(42, v.bulge);
    }
    const Coordinates normal = coordinates(p.axes.normal);
    if (normal[2] != 1) point(210, normal);
  }

  void spatial_polyline(const Dxf_polyline& p, const std::string& layer)
  {
    const std::size_t owner = m_next++;
    object("POLYLINE", owner, model_space, "AcDbEntity");
    group(8, layer);
    m_os << "100\nAcDb3dPolyline\n66\n1\n10\n0\n20\n0\n30\n0\n";
    group(70, 8 + (p.is_closed ? 1 : 0));
    for (const Dxf_vertex& v : p.vertices)
    {
      object("VERTEX", m_next++, owner, "AcDbEntity");
      group(8, layer);
      m_os << "100\nAcDbVertex\n100\nAcDb3dPolylineVertex\n";
      point(10, v.point);
      group(70, 32);
    }
    object("SEQEND", m_next++, owner, "AcDbEntity");
    group(8, layer);
  }

  void objects()
  {
    m_os << "0\nSECTION\n2\nOBJECTS\n";
    object("DICTIONARY", dictionary, 0, "AcDbDictionary");
    group(281, 1);
    group(3, "ACAD_GROUP");
    group(350, hexadecimal(groups));
    group(3, "ACAD_PLOTSTYLENAME");
    group(350, hexadecimal(plot_styles));
    object("DICTIONARY", groups, dictionary, "AcDbDictionary");
    group(281, 1);
    object("ACDBDICTIONARYWDFLT", plot_styles, dictionary, "AcDbDictionary");
    group(281, 1);
    group(3, "Normal");
    group(350, hexadecimal(plot_style));
    group(100, "AcDbDictionaryWithDefault");
    group(340, hexadecimal(plot_style));
    group(0, "ACDBPLACEHOLDER");
    group(5, hexadecimal(plot_style));
    group(330, hexadecimal(plot_styles));
    m_os << "0\nENDSEC\n";
  }

  std::ostream& m_os;
  std::size_t m_next = 0;
};

} // namespace CGAL::IO::Surface_mesh_geodesic_offset_internal

#endif
