# What several workers save on a scene of 50,000 triangles. Included by the Makefile.
WORKERS     := $(BUILD)/workers-test
WORKERS_OBJ := $(call obj,$(sort $(wildcard tests/workers/*.c ports/pthread/*.c)))

$(WORKERS): $(WORKERS_OBJ) $(LIB)
	$(Q)$(CC) $(OPT) $(EXTRA) $^ -lpthread -o $@

.PHONY: workers
workers: $(WORKERS) ## instructions of the busier of two workers, as a part of one's
	$(Q)sh tests/workers/workers.sh $(WORKERS) $(BUILD)/workers

CHECK_STEPS += workers
-include $(WORKERS_OBJ:.o=.d)
