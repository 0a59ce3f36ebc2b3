# Read by ctest (tests/CMakeLists.txt) after the cases are listed: which of them are quick, and which want the machine alone.

# At least one of every label, a session of the window among them: `./dev test --quick`.
set(quick
    "unit\\..*"
    "gpu\\.ClosedForms\\..*"
)
# They measure idle load or frame times.
set(serial
    "ui\\..*"
)

foreach(label unit gpu cli ui)
  foreach(case ${${label}_tests_TESTS})
    foreach(pattern ${quick})
      if(case MATCHES "^${pattern}$")
        set_tests_properties(${case} PROPERTIES LABELS "${label};quick")
      endif()
    endforeach()
    foreach(pattern ${serial})
      if(case MATCHES "^${pattern}$")
        set_tests_properties(${case} PROPERTIES RUN_SERIAL TRUE)
      endif()
    endforeach()
  endforeach()
endforeach()
