#include "step/placements.hpp"

#include <cmath>

#include <StepData_StepModel.hxx>
#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepGeom_Direction.hxx>
#include <StepRepr_MappedItem.hxx>
#include <StepRepr_RepresentationMap.hxx>
#include <StepRepr_ShapeRepresentationRelationshipWithTransformation.hxx>
#include <StepRepr_Transformation.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <TCollection_HAsciiString.hxx>
#include <gp_XYZ.hxx>

namespace moldlight::step {

namespace {

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
