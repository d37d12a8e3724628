# Writes ${OUTPUT}: a table from each file's path below ${ROOT} to its text, which the function ${FUNCTION} of
# ${NAMESPACE} gives as a span of ${TYPE}, both declared in ${HEADER}.
set(table "")
foreach(file IN LISTS FILES)
  file(RELATIVE_PATH name ${ROOT} ${file})
  file(READ ${file} text)
  string(APPEND table "    {\"${name}\", R\"embedded(${text})embedded\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n\nnamespace {\nconstexpr ${TYPE} k_files[] = {\n${table}};\n}  // namespace\n\nstd::span<const ${TYPE}> ${FUNCTION}() { return k_files; }\n\n}  // namespace ${NAMESPACE}\n")
