# Writes ${OUTPUT}: a table from each shader's path below ${ROOT} to its text.
set(table "")
foreach(file IN LISTS FILES)
  file(RELATIVE_PATH name ${ROOT} ${file})
  file(READ ${file} text)
  string(APPEND table "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"gl/shader_text.hpp\"\n\nnamespace moldlight::gl {\n\nnamespace {\nconstexpr ShaderFile k_files[] = {\n${table}};\n}  // namespace\n\nstd::span<const ShaderFile> shader_files() { return k_files; }\n\n}  // namespace moldlight::gl\n")
