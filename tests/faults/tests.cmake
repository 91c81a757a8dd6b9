# What happens when memory or disk runs out; each prints how many faults it injected (scripts/faults.sh adds them up).
copperscope_test(scarce_memory_test faults/scarce_memory_test.cpp LABEL unit LINK copperscope_fuzz_targets copperscope_counted_memory)
copperscope_test(whole_or_nothing_test faults/whole_or_nothing_test.cpp LABEL unit LINK copperscope_model copperscope_counted_memory)
copperscope_test(failing_reads_test faults/failing_reads_test.cpp LABEL unit LINK copperscope_model copperscope_failing_reads)
if(COPPERSCOPE_SANITIZE MATCHES thread)
    # The thread sanitizer's own operators for memory take part of what these two count.
    set_tests_properties(scarce_memory_test whole_or_nothing_test PROPERTIES DISABLED TRUE)
endif()
