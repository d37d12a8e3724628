#include "step/entities.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Quantity_Color.hxx>
#include <STEPConstruct.hxx>
#include <STEPConstruct_Styles.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepGeom_Direction.hxx>
#include <StepRepr_MappedItem.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepRepr_RepresentationMap.hxx>
#include <StepRepr_ShapeRepresentationRelationshipWithTransformation.hxx>
#include <StepRepr_Transformation.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepVisual_Colour.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <gp_XYZ.hxx>

#include "mesh/face_colour.hpp"

namespace moldlight::step {

namespace {

std::uint32_t byte_of(double value) {
  return static_cast<std::uint32_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

/// Of the surface; k_no_colour for a style of lines, or of a colour that has no name.
std::uint32_t colour_of(const STEPConstruct_Styles& styles, const Handle(StepVisual_StyledItem) & style) {
  Handle(StepVisual_Colour) surface, border, curve, rendered;
  Standard_Real transparency = 0.0;
  Standard_Boolean is_component = Standard_False;
  if (!styles.GetColors(style, surface, border, curve, rendered, transparency, is_component))
    return k_no_colour;
  const Handle(StepVisual_Colour)& shown = surface.IsNull() ? rendered : surface;
  Quantity_Color colour;
  if (shown.IsNull() || !STEPConstruct_Styles::DecodeColor(shown, colour)) return k_no_colour;
  Standard_Real red = 0.0, green = 0.0, blue = 0.0;
  colour.Values(red, green, blue, Quantity_TOC_sRGB);
  return byte_of(red) << 16 | byte_of(green) << 8 | byte_of(blue);
}

using Operator = StepGeom_CartesianTransformationOperator3d;

gp_XYZ vector_of(const Handle(StepGeom_Direction) & direction, const gp_XYZ& otherwise) {
  if (direction.IsNull() || direction->NbDirectionRatios() != 3) return otherwise;
  return {direction->DirectionRatiosValue(1), direction->DirectionRatiosValue(2),
          direction->DirectionRatiosValue(3)};
}

/// The operator that places a shape; null where the entity places none or does it otherwise.
Handle(Operator) operator_of(const Handle(Standard_Transient) & entity) {
  if (const auto item = Handle(StepRepr_MappedItem)::DownCast(entity); !item.IsNull()) {
    const bool of_shape =
        !item->MappingSource().IsNull() &&
        !Handle(StepShape_ShapeRepresentation)::DownCast(item->MappingSource()->MappedRepresentation())
             .IsNull();
    return of_shape ? Handle(Operator)::DownCast(item->MappingTarget()) : Handle(Operator)();
  }
  const auto relation = Handle(StepRepr_ShapeRepresentationRelationshipWithTransformation)::DownCast(entity);
  return relation.IsNull() ? Handle(Operator)()
                           : Handle(Operator)::DownCast(relation->TransformationOperator().Value());
}

bool mirrors_or_scales(const Operator& placement) {
  constexpr double k_scale_tolerance = 1e-9;
  if (placement.HasScale() && std::abs(placement.Scale() - 1.0) > k_scale_tolerance) return true;
  // Axes that are left out are those of the world, or follow from the others without mirroring.
  const gp_XYZ x = vector_of(placement.Axis1(), {1, 0, 0}), z = vector_of(placement.Axis3(), {0, 0, 1});
  const gp_XYZ right_handed_y = z.Crossed(x);
  return vector_of(placement.Axis2(), right_handed_y).Dot(right_handed_y) < 0.0;
}

}  // namespace

FaceColours face_colours(const STEPControl_Reader& reader) {
  FaceColours of_face;
  STEPConstruct_Styles styles(reader.WS());
  if (!styles.LoadStyles()) return of_face;
  const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
  std::vector<std::pair<TopoDS_Shape, std::uint32_t>> of_bodies;
  for (Standard_Integer k = 1; k <= styles.NbStyles(); ++k) {
    const Handle(StepVisual_StyledItem) style = styles.Style(k);
    const std::uint32_t colour = colour_of(styles, style);
    if (colour == k_no_colour || style->Item().IsNull()) continue;
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, style->Item());
    if (shape.IsNull()) continue;
    if (shape.ShapeType() == TopAbs_FACE) {
      of_face.insert_or_assign(shape.TShape().get(), colour);
    } else {
      of_bodies.emplace_back(shape, colour);
    }
  }
  for (const auto& [body, colour] : of_bodies)
    for (TopExp_Explorer walk(body, TopAbs_FACE); walk.More(); walk.Next())
      of_face.try_emplace(walk.Current().TShape().get(), colour);
  return of_face;
}

std::string mirrored_or_scaled_placement(const STEPControl_Reader& reader) {
  const Handle(StepData_StepModel) model = reader.StepModel();
  for (Standard_Integer i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Operator) placement = operator_of(model->Value(i));
    if (!placement.IsNull() && mirrors_or_scales(*placement))
      return model->StringLabel(placement)->ToCString();
  }
  return "";
}

}  // namespace moldlight::step
