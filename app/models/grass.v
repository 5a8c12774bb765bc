angle increment: 45
initial line width: 0.3
initial color: 1
tropism direction: 0,1,0
material: 1 culm kind=stem color=0.66,0.63,0.34 roughness=0.6
material: 2 blade kind=leaf color=0.40,0.54,0.20 roughness=0.55 translucency=0.4
material: 3 spikelet kind=petal color=0.83,0.72,0.50 roughness=0.8 translucency=0.4
organ: g blade kind=blade material=2 length=62 width=0.95 petiole=0 widest=0.25 tip=0.8 base=0.9 fold=26 curl=95
organ: s sheath kind=blade material=2 length=26 width=0.7 petiole=0 widest=0.25 tip=0.8 base=0.9 fold=26 curl=60
organ: k spikelet kind=blade material=3 length=4.6 width=0.75 petiole=0 widest=0.4 tip=0.9 base=0.8 fold=30 curl=15
