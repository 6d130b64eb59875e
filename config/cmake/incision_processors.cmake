# The tests of the stages that add up much, as other processors would run them: what holds with one arithmetic must hold
# with each. A test of a whole program each, beside those that run on what this processor has;
# they take longest, so they begin first.
set(stages solver contact fracture tool body)

function(incision_on_processor name)
  foreach(stage IN LISTS stages)
    set(test quick.${name}.${stage})
    add_test(NAME ${test} COMMAND incision_${stage}_tests --gtest_brief=1 --gtest_filter=-Full*:*.Full*)
    set_tests_properties(${test} PROPERTIES LABELS quick TIMEOUT 900 COST 100 ENVIRONMENT "${ARGN}")
  endforeach()
endfunction()

# Without AVX2 and FMA: the plain library, and the BLAS and the mathematical functions of such a processor.
incision_on_processor(plain GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA OPENBLAS_CORETYPE=Nehalem)

# With AVX2 but not AVX-512, for which the BLAS has other kernels.
file(STRINGS /proc/cpuinfo avx2 REGEX " avx2 " LIMIT_COUNT 1)
if(avx2)
  incision_on_processor(haswell OPENBLAS_CORETYPE=Haswell)
endif()
