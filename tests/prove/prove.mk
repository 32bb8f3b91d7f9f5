# Value ranges, overflow and exactness by Frama-C (EVA, WP with z3). See README.md.
.PHONY: prove
prove: ## what Frama-C proves of core's arithmetic, and that broken sources are not proved
	$(Q)sh tests/prove/prove.sh $(BUILD)/prove
	$(Q)sh tests/prove/selftest.sh $(BUILD)/prove
