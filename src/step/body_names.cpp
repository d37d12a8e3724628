#include "step/body_names.hpp"

#include <algorithm>
#include <vector>

#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepRepr_CharacterizedDefinition.hxx>
#include <StepRepr_PropertyDefinition.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepRepr_RepresentationRelationship.hxx>
#include <StepRepr_RepresentationRelationshipWithTransformation.hxx>
#include <StepRepr_RepresentedDefinition.hxx>
#include <StepRepr_ShapeRepresentationRelationshipWithTransformation.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

namespace moldlight::step {

namespace {

std::string text_of(const Handle(TCollection_HAsciiString) & text) {
  return text.IsNull() ? std::string() : std::string(text->ToCString());
}

std::string product_name(const Handle(StepShape_ShapeDefinitionRepresentation) & link) {
  const auto property = link->Definition().PropertyDefinition();
  if (property.IsNull()) return "";
  const auto definition = property->Definition().ProductDefinition();
  if (definition.IsNull() || definition->Formation().IsNull() ||
      definition->Formation()->OfProduct().IsNull())
    return "";
  return text_of(definition->Formation()->OfProduct()->Name());
}

/// Name of the product that an item is the shape of: walks from the item to the representations that hold it,
/// across relations that place nothing (those that do lead to an assembly), to the link with a product.
std::string product_name(const STEPControl_Reader& reader, const Handle(Standard_Transient) & item) {
  constexpr std::size_t k_max_visited = 1000;
  const Interface_Graph& graph = reader.WS()->Graph();
  std::vector<Handle(Standard_Transient)> visited = {item};
  const auto visit = [&](const Handle(Standard_Transient) & entity) {
    if (!entity.IsNull() && std::find(visited.begin(), visited.end(), entity) == visited.end())
      visited.push_back(entity);
  };
  for (std::size_t next = 0; next < visited.size() && visited.size() < k_max_visited; ++next) {
    Interface_EntityIterator users = graph.Sharings(visited[next]);
    for (users.Start(); users.More(); users.Next()) {
      const Handle(Standard_Transient)& user = users.Value();
      if (const auto link = Handle(StepShape_ShapeDefinitionRepresentation)::DownCast(user); !link.IsNull()) {
        return product_name(link);
      }
      if (user->IsKind(STANDARD_TYPE(StepRepr_Representation))) visit(user);
      const auto relation = Handle(StepRepr_RepresentationRelationship)::DownCast(user);
      if (relation.IsNull() ||
          user->IsKind(STANDARD_TYPE(StepRepr_RepresentationRelationshipWithTransformation)) ||
          user->IsKind(STANDARD_TYPE(StepRepr_ShapeRepresentationRelationshipWithTransformation))) {
        continue;
      }
      visit(relation->Rep1());
      visit(relation->Rep2());
    }
  }
  return "";
}

}  // namespace

std::string body_name(const STEPControl_Reader& reader, const TopoDS_Shape& shape) {
  const auto entity =
      reader.WS()->TransferReader()->EntityFromShapeResult(shape.Located(TopLoc_Location()), 1);
  if (entity.IsNull()) return "";
  const auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity);
  const std::string name = item.IsNull() ? std::string() : text_of(item->Name());
  return name.empty() || name == "NONE" ? product_name(reader, entity) : name;
}

}  // namespace moldlight::step
