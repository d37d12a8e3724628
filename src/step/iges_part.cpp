#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <ShapeFix_Solid.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <XSControl_WorkSession.hxx>

#include "step/cad_part.hpp"

namespace moldlight::step {

namespace {

constexpr double k_sewn_share = 1e-4;  // gaps that are closed, of the diagonal

LengthUnit unit_of(const IGESData_GlobalSection& global, CadPart& part) {
  const char* word = "";
  switch (global.UnitFlag()) {
    case 1:
      word = "in";
      break;
    case 2:
      word = "mm";
      break;
    case 4:
      word = "ft";
      break;
    case 6:
      word = "m";
      break;
    case 9:
      word = "um";
      break;
    case 10:
      word = "cm";
      break;
    default:
      break;
  }
  if (const auto unit = find_length_unit(word)) return *unit;
  part.warnings.push_back("the length unit of the IGES file is unknown; lengths are in millimetres");
  return {"mm", 1.0};
}

std::size_t count_failed(Interface_CheckIterator checks) {
  std::size_t count = 0;
  for (checks.Start(); checks.More(); checks.Next()) count += checks.Value()->HasFailed() ? 1 : 0;
  return count;
}

/// Faces that no solid has, joined where they meet: solids where that closes them, else shells and faces.
std::vector<TopoDS_Shape> sewn(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  if (box.IsVoid() || box.IsOpen())
    throw std::runtime_error("holds no bounded shape; export the part as a solid");
  BRepBuilderAPI_Sewing sewing(k_sewn_share * std::sqrt(box.SquareExtent()));
  std::vector<TopoDS_Shape> bodies;
  bool any = false;
  for (TopExp_Explorer walk(shape, TopAbs_FACE, TopAbs_SOLID); walk.More(); walk.Next(), any = true)
    sewing.Add(walk.Current());
  if (!any) return bodies;
  sewing.Perform();
  for (TopExp_Explorer walk(sewing.SewedShape(), TopAbs_SHELL); walk.More(); walk.Next()) {
    const TopoDS_Shell& shell = TopoDS::Shell(walk.Current());
    const TopoDS_Solid solid =
        BRep_Tool::IsClosed(shell) ? ShapeFix_Solid().SolidFromShell(shell) : TopoDS_Solid();
    bodies.push_back(solid.IsNull() ? TopoDS_Shape(shell) : TopoDS_Shape(solid));
  }
  for (TopExp_Explorer walk(sewing.SewedShape(), TopAbs_FACE, TopAbs_SHELL); walk.More(); walk.Next())
    bodies.push_back(walk.Current());
  return bodies;
}

}  // namespace

CadPart read_iges() {
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  IGESControl_Reader reader;
  if (reader.ReadFile(k_iges_name) != IFSelect_RetDone)
    throw std::runtime_error("is not an IGES file that can be read; export the part again");
  CadPart part;
  const Handle(IGESData_IGESModel) model = reader.IGESModel();
  part.unit = unit_of(model->GlobalSection(), part);
  reader.TransferRoots();
  const std::size_t faulty =
      count_failed(reader.WS()->ModelCheckList()) + count_failed(reader.WS()->LastRunCheckList());
  if (faulty > 0)
    part.warnings.push_back(std::to_string(faulty) + (faulty == 1 ? " entity" : " entities") +
                            " of the IGES file cannot be taken over; some of the part may be missing");
  const TopoDS_Shape shape = reader.OneShape();
  if (shape.IsNull()) throw std::runtime_error("holds no shape; export the part as a solid");
  for (TopExp_Explorer walk(shape, TopAbs_SOLID); walk.More(); walk.Next())
    part.bodies.push_back({walk.Current(), ""});
  for (const TopoDS_Shape& body : sewn(shape)) part.bodies.push_back({body, ""});
  if (part.bodies.empty()) throw std::runtime_error("holds no face; export the part as a solid");
  return part;
}

}  // namespace moldlight::step
