# Writes ${PAGE}, a live report of ${PART} by the program ${MOLDLIGHT}; a page that says why where that fails. The command
# line that the report shows has no folder of this machine.
get_filename_component(name ${PART} NAME)
file(COPY ${PART} DESTINATION parts)
execute_process(COMMAND ${MOLDLIGHT} sweep parts/${name} --unit mm --quiet --html live.html --live
                OUTPUT_QUIET ERROR_VARIABLE said RESULT_VARIABLE failed)
if(failed)
  file(WRITE live.html "<!DOCTYPE html><title>moldlight</title><p>This page could not be made: ${said}")
endif()
file(COPY_FILE live.html ${PAGE})
