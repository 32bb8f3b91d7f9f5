# Value ranges, overflow and exactness by Frama-C (EVA, WP with z3), rounding by gappa. See README.md.
.PHONY: prove
prove: ## what Frama-C and gappa prove of core's arithmetic, and that broken sources are not proved
	$(Q)sh tests/prove/selftest.sh $(BUILD)/prove
	$(Q)$(STEPS) $(BUILD)/prove/steps ranges "sh tests/prove/prove.sh $(BUILD)/prove" \
	    rounding "sh tests/prove/rounding.sh $(BUILD)/prove"
