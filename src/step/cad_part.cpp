#include "step/cad_part.hpp"

#include <algorithm>
#include <cstdlib>
#include <istream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <IGESControl_Controller.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPConstruct_UnitContext.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx.hxx>
#include <StepRepr_CharacterizedDefinition.hxx>
#include <StepRepr_GlobalUncertaintyAssignedContext.hxx>
#include <StepRepr_GlobalUnitAssignedContext.hxx>
#include <StepRepr_PropertyDefinition.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepRepr_RepresentationRelationship.hxx>
#include <StepRepr_RepresentationRelationshipWithTransformation.hxx>
#include <StepRepr_RepresentedDefinition.hxx>
#include <StepRepr_ShapeRepresentationRelationshipWithTransformation.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_AsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

namespace moldlight::step {

namespace {

/// What the parser says of the syntax of a file, to printers only: while it is added to the default
/// messenger, keeps the line of the first fault. The parser drops the entity there and goes on, so that a
/// part of the file is lost.
class SyntaxFaults : public Message_Printer {
 public:
  SyntaxFaults() { SetTraceLevel(Message_Trace); }  // the least of all, as which the parser counts them

  /// From 1; 0 where the syntax is sound.
  [[nodiscard]] std::size_t first_line() const { return first_line_; }

 protected:
  void send(const TCollection_AsciiString& message, Message_Gravity /*gravity*/) const override {
    // "**** ERR StepFile : Undefined Parsing: Line 121: Incorrect syntax: …"
    constexpr std::string_view k_fault = "Undefined Parsing: Line ";
    const std::string_view text(message.ToCString());
    const std::size_t at = text.find(k_fault);
    if (first_line_ > 0 || at == std::string_view::npos) return;
    // OpenCASCADE counts one line too many.
    const auto line = static_cast<std::size_t>(std::strtoull(text.data() + at + k_fault.size(), nullptr, 10));
    first_line_ = std::max<std::size_t>(line, 2) - 1;
  }

 private:
  mutable std::size_t first_line_ = 0;
};

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
      if (const auto link = Handle(StepShape_ShapeDefinitionRepresentation)::DownCast(user); !link.IsNull())
        return product_name(link);
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

std::string body_name(const STEPControl_Reader& reader, const TopoDS_Shape& shape) {
  const auto entity =
      reader.WS()->TransferReader()->EntityFromShapeResult(shape.Located(TopLoc_Location()), 1);
  if (entity.IsNull()) return "";
  const auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity);
  const std::string name = item.IsNull() ? std::string() : text_of(item->Name());
  return name.empty() || name == "NONE" ? product_name(reader, entity) : name;
}

constexpr LengthUnit k_millimetre{"mm", 1.0};

/// OpenCASCADE gives millimetres; the result is in the file's unit where that is known.
LengthUnit file_unit(STEPControl_Reader& reader, CadPart& part) {
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.FileUnits(lengths, angles, solid_angles);
  if (lengths.IsEmpty()) {
    part.warnings.push_back("the STEP file names no unit; millimetres were assumed");
    return k_millimetre;
  }
  TCollection_AsciiString word = lengths.First();
  word.LowerCase();
  for (Standard_Integer i = 2; i <= lengths.Length(); ++i) {
    TCollection_AsciiString other = lengths.Value(i);
    other.LowerCase();
    if (!other.IsEqual(word)) {
      part.warnings.push_back("the STEP file mixes units; all lengths were brought to millimetres");
      return k_millimetre;
    }
  }
  if (const auto unit = find_length_unit(word.ToCString())) return *unit;
  part.warnings.push_back(std::string("the length unit '") + word.ToCString() +
                          "' is unknown; lengths are in millimetres");
  return k_millimetre;
}

double accuracy_of(const Handle(StepData_StepModel) & model) {
  double accuracy = 0.0;
  for (Standard_Integer k = 1; k <= model->NbEntities(); ++k) {
    const auto context =
        Handle(StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx)::DownCast(model->Value(k));
    if (context.IsNull()) continue;
    STEPConstruct_UnitContext units;
    units.ComputeFactors(context->GlobalUnitAssignedContext());
    units.ComputeTolerance(context->GlobalUncertaintyAssignedContext());
    if (units.HasUncertainty()) accuracy = std::max(accuracy, units.Uncertainty() * units.LengthFactor());
  }
  return accuracy;
}

/// Entities of shape that a list of checks finds faulty, and faults of the file as a whole.
std::size_t count_faulty(const STEPControl_Reader& reader, Interface_CheckIterator checks) {
  std::size_t count = 0;
  for (checks.Start(); checks.More(); checks.Next()) {
    if (!checks.Value()->HasFailed()) continue;
    const Standard_Integer number = checks.Number();
    const bool of_file = number <= 0 || number > reader.StepModel()->NbEntities();
    if (of_file || reader.StepModel()->Value(number)->IsKind(STANDARD_TYPE(StepRepr_RepresentationItem)))
      ++count;
  }
  return count;
}

/// Solids, then shells outside any solid, then faces outside any shell.
std::vector<TopoDS_Shape> bodies_of(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> bodies;
  for (TopExp_Explorer walk(shape, TopAbs_SOLID); walk.More(); walk.Next()) bodies.push_back(walk.Current());
  for (TopExp_Explorer walk(shape, TopAbs_SHELL, TopAbs_SOLID); walk.More(); walk.Next())
    bodies.push_back(walk.Current());
  for (TopExp_Explorer walk(shape, TopAbs_FACE, TopAbs_SHELL); walk.More(); walk.Next())
    bodies.push_back(walk.Current());
  return bodies;
}

}  // namespace

void prepare() {
  STEPControl_Controller::Init();
  IGESControl_Controller::Init();
}

CadPart read_step(std::istream& file) {
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  const Handle(SyntaxFaults) syntax_faults = new SyntaxFaults;
  Message::DefaultMessenger()->AddPrinter(syntax_faults);
  STEPControl_Reader reader;
  const bool was_read = reader.ReadStream("part.step", file) == IFSelect_RetDone;
  if (syntax_faults->first_line() > 0) {
    throw std::runtime_error("line " + std::to_string(syntax_faults->first_line()) +
                             ": this is not what STEP allows here; export the part again");
  }
  if (!was_read) throw std::runtime_error("is not a STEP file that can be read; export the part again");
  if (const std::string placement = mirrored_or_scaled_placement(reader); !placement.empty()) {
    throw std::runtime_error("entity " + placement +
                             ": this mirrors or scales a part of the assembly, which OpenCASCADE cannot do; "
                             "export the mirrored part as a solid of its own");
  }
  CadPart part;
  std::size_t faulty = count_faulty(reader, reader.WS()->ModelCheckList());
  part.unit = file_unit(reader, part);
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  reader.TransferRoots();
  const TopoDS_Shape shape = reader.OneShape();
  faulty += count_faulty(reader, reader.WS()->LastRunCheckList());
  if (faulty > 0) {
    part.warnings.push_back(
        std::to_string(faulty) +
        (faulty == 1 ? " entity of the STEP file is faulty" : " entities of the STEP file are faulty") +
        "; some of the part may be missing or of another size");
  }
  if (shape.IsNull()) throw std::runtime_error("holds no shape; export the part as a solid");
  for (const TopoDS_Shape& body : bodies_of(shape)) part.bodies.push_back({body, body_name(reader, body)});
  if (part.bodies.empty()) throw std::runtime_error("holds no face; export the part as a solid");
  part.colours = face_colours(reader);
  part.accuracy = accuracy_of(reader.StepModel());
  return part;
}

}  // namespace moldlight::step
