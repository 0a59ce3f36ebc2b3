# pileus_embed(TARGET name FILES a.glsl b.ttf ...): links the files' bytes into TARGET (assembler .incbin, so that large fonts cost
# no compile time) and generates embedded_<name>.h with `std::span<const pileus::EmbeddedFile> embedded_<name>()`, keyed by the
# path relative to BASE.
function(pileus_embed)
  cmake_parse_arguments(ARG "" "TARGET;NAME;BASE" "FILES" ${ARGN})
  set(dir ${CMAKE_CURRENT_BINARY_DIR}/embedded)
  set(asm ".section .rodata\n")
  set(decls "")
  set(rows "")
  set(index 0)
  foreach(file ${ARG_FILES})
    file(RELATIVE_PATH key ${ARG_BASE} ${file})
    set(symbol pileus_${ARG_NAME}_${index})
    string(APPEND asm ".global ${symbol}_begin\n.global ${symbol}_end\n.balign 16\n${symbol}_begin:\n.incbin \"${file}\"\n${symbol}_end:\n.byte 0\n")
    string(APPEND decls "extern \"C\" const char ${symbol}_begin[];\nextern \"C\" const char ${symbol}_end[];\n")
    string(APPEND rows "      {\"${key}\", {${symbol}_begin, ${symbol}_end}},\n")
    math(EXPR index "${index} + 1")
  endforeach()
  string(APPEND asm ".section .note.GNU-stack,\"\",@progbits\n")
  file(CONFIGURE OUTPUT ${dir}/embedded_${ARG_NAME}.S CONTENT "${asm}" @ONLY)
  file(CONFIGURE OUTPUT ${dir}/embedded_${ARG_NAME}.h CONTENT
"#pragma once
#include <span>
#include \"renderer/base/embedded.h\"
namespace pileus {
std::span<const EmbeddedFile> embedded_${ARG_NAME}();
}
" @ONLY)
  file(CONFIGURE OUTPUT ${dir}/embedded_${ARG_NAME}.cpp CONTENT
"#include \"embedded_${ARG_NAME}.h\"
${decls}
namespace pileus {
std::span<const EmbeddedFile> embedded_${ARG_NAME}() {
  static const EmbeddedFile files[] = {
${rows}  };
  return files;
}
}
" @ONLY)
  set_source_files_properties(${dir}/embedded_${ARG_NAME}.S PROPERTIES OBJECT_DEPENDS "${ARG_FILES}")
  target_sources(${ARG_TARGET} PRIVATE ${dir}/embedded_${ARG_NAME}.cpp ${dir}/embedded_${ARG_NAME}.S)
  target_include_directories(${ARG_TARGET} PRIVATE ${dir})
endfunction()
