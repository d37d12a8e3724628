#include "step/part_writer.hpp"

#include <cstddef>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPConstruct.hxx>
#include <STEPConstruct_Styles.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepVisual_HArray1OfLayeredItem.hxx>
#include <StepVisual_LayeredItem.hxx>
#include <StepVisual_MechanicalDesignGeometricPresentationRepresentation.hxx>
#include <StepVisual_PresentationLayerAssignment.hxx>
#include <StepVisual_PresentationStyleAssignment.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>

#include "step/face_split.hpp"
#include "step/parting_shell.hpp"

namespace moldlight::step {

namespace {

Handle(TCollection_HAsciiString) text(const std::string& value) {
  return new TCollection_HAsciiString(value.c_str());
}

/// Bodies whose faces are theirs alone, which those of an assembly that has one part twice are not.
std::vector<PlacedBody> own_bodies(const CadPart& part) {
  std::vector<PlacedBody> bodies;
  std::set<const TopoDS_TShape*> seen;
  for (const CadBody& body : part.bodies) {
    PlacedBody own{body.shape.Located(TopLoc_Location()), body.shape.Location().Transformation()};
    bool shared = false;
    for (TopExp_Explorer walk(own.shape, TopAbs_FACE); walk.More(); walk.Next())
      shared = !seen.insert(walk.Current().TShape().get()).second || shared;
    if (shared) own.shape = BRepBuilderAPI_Copy(own.shape, Standard_True, Standard_True).Shape();
    bodies.push_back(own);
  }
  return bodies;
}

/// What one part of the file becomes is looked up by these.
class Labeller {
 public:
  Labeller(STEPControl_Writer& writer, const StepLabels& labels)
      : labels_(labels),
        model_(Handle(StepData_StepModel)::DownCast(writer.WS()->Model())),
        finder_(writer.WS()->TransferWriter()->FinderProcess()),
        styles_(writer.WS()),
        of_label_(labels.names.size()) {}

  void name(const TopoDS_Shape& shape, const std::string& name) {
    const auto item = entity_of(shape);
    if (!item.IsNull() && !name.empty()) item->SetName(text(name));
  }

  void add(const LabelledFace& face) {
    const auto item = entity_of(face.face);
    if (item.IsNull()) throw std::runtime_error("has a face that OpenCASCADE does not write");
    const std::uint32_t rgb = labels_.colours.at(face.label);
    const auto part = [rgb](int shift) { return static_cast<double>((rgb >> shift) & 0xFFU) / 255.0; };
    item->SetName(text(labels_.names.at(face.label)));
    const Handle(StepVisual_Colour) colour = STEPConstruct_Styles::EncodeColor(
        Quantity_Color(part(16), part(8), part(0), Quantity_TOC_sRGB), predefined_, own_);
    styles_.AddStyle(item, styles_.GetColorPSA(item, colour), nullptr);
    of_label_[face.label].push_back(item);
  }

  void finish(const TopoDS_Shape& body) {
    Handle(StepVisual_MechanicalDesignGeometricPresentationRepresentation) shown;
    const auto context = styles_.FindContext(body);
    if (context.IsNull() || !styles_.CreateMDGPR(context, shown))
      throw std::runtime_error("has faces that OpenCASCADE does not colour");
    model_->AddWithRefs(shown);
    for (std::size_t label = 0; label < of_label_.size(); ++label) {
      const auto& items = of_label_[label];
      if (items.empty()) continue;
      const Handle(StepVisual_HArray1OfLayeredItem) layered =
          new StepVisual_HArray1OfLayeredItem(1, static_cast<int>(items.size()));
      for (std::size_t k = 0; k < items.size(); ++k) {
        StepVisual_LayeredItem item;
        item.SetValue(items[k]);
        layered->SetValue(static_cast<int>(k) + 1, item);
      }
      const Handle(StepVisual_PresentationLayerAssignment) layer = new StepVisual_PresentationLayerAssignment;
      layer->Init(text(labels_.names[label]), text(""), layered);
      model_->AddWithRefs(layer);
    }
  }

 private:
  [[nodiscard]] Handle(StepRepr_RepresentationItem) entity_of(const TopoDS_Shape& shape) const {
    return STEPConstruct::FindEntity(finder_, shape);
  }

  const StepLabels& labels_;
  Handle(StepData_StepModel) model_;
  Handle(Transfer_FinderProcess) finder_;
  STEPConstruct_Styles styles_;
  STEPConstruct_DataMapOfAsciiStringTransient predefined_;
  STEPConstruct_DataMapOfPointTransient own_;
  std::vector<std::vector<Handle(StepRepr_RepresentationItem)>> of_label_;
};

TopoDS_Wire wire_of(const StepLine& line) {
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  const auto vertex = [](const std::array<double, 3>& at) {
    return TopoDS_Vertex(BRepBuilderAPI_MakeVertex(gp_Pnt(at[0], at[1], at[2])));
  };
  TopoDS_Vertex first, last;
  for (std::size_t k = 0; k < line.points.size(); ++k) {
    const bool closes = k + 1 == line.points.size() && line.points.back() == line.points.front();
    const TopoDS_Vertex next = closes ? first : vertex(line.points[k]);
    if (k == 0) {
      first = next;
    } else if (const BRepBuilderAPI_MakeEdge edge(last, next); edge.IsDone()) {
      builder.Add(wire, TopoDS_Edge(BRepBuilderAPI_MakeEdge(last, next)));
    } else {
      continue;
    }
    last = next;
  }
  return wire;
}

void transfer(STEPControl_Writer& writer, const TopoDS_Shape& shape) {
  if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone)
    throw std::runtime_error("cannot be written by OpenCASCADE as STEP; use --mesh");
}

void name_product(const Handle(StepData_StepModel) & model, const std::string& name) {
  for (int k = 1; k <= model->NbEntities(); ++k) {
    const auto product = Handle(StepBasic_Product)::DownCast(model->Value(k));
    if (product.IsNull()) continue;
    product->SetName(text(name.empty() ? "part" : name));
    product->SetId(product->Name());
  }
}

}  // namespace

StepWritten write_labelled(const CadPart& part, const StepLabels& labels) {
  LabelledPart labelled = split_faces(own_bodies(part), labels);
  std::erase_if(labelled.faces, [](const LabelledFace& face) { return face.label == StepLabels::k_none; });
  std::set<const TopoDS_TShape*> shown;
  for (const LabelledFace& face : labelled.faces) shown.insert(face.face.TShape().get());
  Interface_Static::SetCVal("write.step.unit", "MM");
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetIVal("write.step.assembly", 0);
  if (part.accuracy > 0.0) {
    // Readers bring edges to surfaces by it, so that with another one the part has another volume.
    Interface_Static::SetIVal("write.precision.mode", 2);
    Interface_Static::SetRVal("write.precision.val", part.accuracy);
  }
  TopoDS_Compound all;
  const BRep_Builder builder;
  builder.MakeCompound(all);
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < labelled.bodies.size(); ++k) {
    bool any = false;
    for (TopExp_Explorer walk(labelled.bodies[k], TopAbs_FACE); walk.More() && !any; walk.Next())
      any = shown.contains(walk.Current().TShape().get());
    if (!any) continue;
    builder.Add(all, labelled.bodies[k]);
    kept.push_back(k);
  }
  if (kept.empty()) throw std::runtime_error("has no body to write");
  STEPControl_Writer writer;
  std::vector<TopoDS_Wire> wires;
  for (const StepLine& line : labels.lines) {
    wires.push_back(wire_of(line));
    builder.Add(all, wires.back());
  }
  std::vector<TopoDS_Shell> surfaces;
  for (const StepSurface& surface : labels.surfaces) {
    surfaces.push_back(shell_of(surface));
    builder.Add(all, surfaces.back());
  }
  // One product, of the lines too: several that stand beside each other end FreeCAD 0.20.
  const TopoDS_Shape& written =
      kept.size() == 1 && wires.empty() && surfaces.empty() ? labelled.bodies[kept.front()] : all;
  transfer(writer, written);
  Labeller labeller(writer, labels);
  for (std::size_t k = 0; k < wires.size(); ++k) labeller.name(wires[k], labels.lines[k].name);
  for (std::size_t k = 0; k < surfaces.size(); ++k) labeller.name(surfaces[k], labels.surfaces[k].name);
  for (const std::size_t k : kept) labeller.name(labelled.bodies[k], part.bodies[k].name);
  for (const LabelledFace& face : labelled.faces) labeller.add(face);
  labeller.finish(written);

  const Handle(StepData_StepModel) model = Handle(StepData_StepModel)::DownCast(writer.WS()->Model());
  name_product(model, kept.size() == 1 ? part.bodies[kept.front()].name : "");
  APIHeaderSection_MakeHeader header(model);
  header.SetTimeStamp(text("1970-01-01T00:00:00"));
  header.SetAuthorValue(1, text(""));
  header.SetOrganizationValue(1, text(""));
  header.SetOriginatingSystem(text("moldlight"));
  header.SetName(text("part"));
  header.Apply(model);
  StepData_StepWriter text_writer(model);
  text_writer.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
  std::ostringstream out;
  if (!text_writer.Print(out)) throw std::runtime_error("cannot be written by OpenCASCADE as STEP");
  StepWritten result;
  result.failed_faces = std::move(labelled.failed_faces);
  result.areas.assign(labels.names.size(), 0.0);
  for (const LabelledFace& face : labelled.faces) result.areas.at(face.label) += face.area;
  result.file = std::move(out).str();
  return result;
}

}  // namespace moldlight::step
