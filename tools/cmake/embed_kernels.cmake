# SPDX-License-Identifier: Apache-2.0
# Puts the kernel sources into the library. In: a folder of .cl, .clh and .h files; out: a .cpp that defines
# cdsm::device::embeddedFiles() (host/src/device/embedded_file.hpp), written anew when one of them changes.
# Included by CMakeLists.txt it defines cdsm_embed_kernels(); run with cmake -P it writes the .cpp.

# Call as cdsm_embed_kernels(SOURCE_DIR OUTPUT_CPP), both absolute; then add OUTPUT_CPP to a target.
function(cdsm_embed_kernels source_dir output_cpp)
  file(GLOB_RECURSE kernel_files CONFIGURE_DEPENDS
       ${source_dir}/*.cl ${source_dir}/*.clh ${source_dir}/*.h)
  add_custom_command(
    OUTPUT ${output_cpp}
    COMMAND ${CMAKE_COMMAND} -DCDSM_SOURCE_DIR=${source_dir} -DCDSM_OUTPUT_CPP=${output_cpp}
            -P ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    DEPENDS ${kernel_files} ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    COMMENT "Embedding kernels"
    VERBATIM)
endfunction()

# Sets ${result} to raw string literals, cut at line ends: compilers may limit the length of one literal.
function(cdsm_raw_literals text result)
  set(piece_length 8000)
  set(literals "")
  string(LENGTH "${text}" rest_length)
  while(rest_length GREATER ${piece_length})
    string(SUBSTRING "${text}" 0 ${piece_length} piece)
    string(FIND "${piece}" "\n" cut REVERSE)
    if(cut EQUAL -1)
      message(FATAL_ERROR "kernel sources must have lines shorter than ${piece_length} bytes")
    endif()
    math(EXPR cut "${cut} + 1")
    string(SUBSTRING "${text}" 0 ${cut} piece)
    string(SUBSTRING "${text}" ${cut} -1 text)
    string(APPEND literals "R\"~cdsm~(${piece})~cdsm~\"\n")
    string(LENGTH "${text}" rest_length)
  endwhile()
  set(${result} "${literals}R\"~cdsm~(${text})~cdsm~\"" PARENT_SCOPE)
endfunction()

function(cdsm_write_embedded source_dir output_cpp)
  file(GLOB_RECURSE paths RELATIVE ${source_dir} ${source_dir}/*.cl ${source_dir}/*.clh ${source_dir}/*.h)
  list(SORT paths)
  set(entries "")
  set(count 0)
  foreach(path IN LISTS paths)
    file(READ "${source_dir}/${path}" text)
    cdsm_raw_literals("${text}" literals)
    string(APPEND entries "    {\"${path}\", ${literals}},\n")
    math(EXPR count "${count} + 1")
  endforeach()
  # The last entry keeps the array legal when there is no file; it does not count.
  file(WRITE "${output_cpp}"
"// Generated from the kernels folder by tools/cmake/embed_kernels.cmake: edit the kernels instead.
#include \"device/embedded_file.hpp\"

namespace cdsm::device {
namespace {
constexpr EmbeddedFile kFiles[] = {
${entries}    {nullptr, nullptr},
};
}  // namespace

const EmbeddedFile* embeddedFiles() { return kFiles; }
std::size_t embeddedFileCount() { return ${count}; }
}  // namespace cdsm::device
")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  cdsm_write_embedded("${CDSM_SOURCE_DIR}" "${CDSM_OUTPUT_CPP}")
endif()
