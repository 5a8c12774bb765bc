angle increment: 45
initial line width: 0.3
initial color: 1
tropism direction: 0,1,0
initial elasticity: 0.03
material: 1 stem kind=stem color=0.33,0.48,0.19 roughness=0.6
material: 2 leaf kind=leaf color=0.24,0.42,0.15 roughness=0.5 translucency=0.35
material: 3 petal kind=petal color=0.97,0.96,0.93 roughness=0.6 translucency=0.3
material: 4 disc kind=solid color=0.95,0.72,0.10 roughness=0.85
organ: r rosette kind=blade material=2 length=13 width=3.6 petiole=5 widest=0.6 tip=0.4 base=0.9 lobes=0.25 lobe_count=4 fold=12 curl=45
organ: l leaf kind=blade material=2 length=7 width=1.7 petiole=0.3 widest=0.5 tip=0.7 base=0.5 lobes=0.3 lobe_count=5 fold=15 curl=30
organ: p petal kind=blade material=3 length=2.6 width=0.62 petiole=0.5 widest=0.6 tip=0.15 base=0.5 fold=8 curl=18
organ: d disc kind=disc material=4 length=0.7 width=1.7
