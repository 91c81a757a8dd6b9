copperscope_test(generate_job_writer_test unit/generate/job_writer_test.cpp LABEL unit
    LINK copperscope_model)
